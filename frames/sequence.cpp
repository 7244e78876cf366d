#include "frames/sequence.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <string>
#include <system_error>

#include "frames/atomic_file.h"
#include "frames/contact_strip.h"
#include "frames/errors.h"
#include "frames/film.h"
#include "frames/frame_queue.h"
#include "frames/interrupt.h"
#include "frames/manifest.h"
#include "frames/progress.h"
#include "frames/sequence_folder.h"
#include "frames/video.h"
#include "viz/gl/context.h"
#include "viz/image/png.h"

namespace kerf {
namespace {

Manifest begin_manifest(const RenderRequest& request) {
  Manifest manifest;
  manifest.scene = request.scene.name;
  manifest.dimension = request.scene.dimension();
  manifest.needs = std::visit([](const auto* entry) { return describe(entry->needs); }, request.scene.entry);
  manifest.seed = request.options.seed;
  manifest.requested_objects = request.options.objects;
  manifest.grow = request.options.steps;
  manifest.steps = request.steps;
  manifest.size = request.size;
  manifest.layers = to_string(request.layers);
  manifest.camera = request.camera;
  manifest.broad_phase = request.broad_phase.name;
  if (request.broad_phase.is_tree()) manifest.config = request.broad_phase.config;
  manifest.volume = to_string(request.broad_phase.volume);
  manifest.recycle = request.options.recycle;
  return manifest;
}

/// A film or contact sheet replaces an earlier file only if the user said so.
void check_free(const std::filesystem::path& file, bool overwrite) {
  if (file.empty() || overwrite || !std::filesystem::exists(file)) return;
  throw UsageError(file.string() + " exists already; choose another name, or replace it with --overwrite");
}

/// So many pictures may wait for the disk: enough to smooth its delays, little enough for memory.
std::size_t queue_capacity(PictureSize size) {
  constexpr std::size_t kBytes = 64U << 20U;
  const std::size_t picture =
      4 * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  return std::clamp<std::size_t>(kBytes / picture, 1, 8);
}

/// The work on one sequence; the second thread uses `manifest_`, `video_` and `strip_` until the queue is
/// done.
class Sequence {
 public:
  explicit Sequence(const RenderRequest& request)
      : request_(request),
        folder_(request.out, request.overwrite),
        film_(make_film(request)),
        manifest_(begin_manifest(request)),
        strip_(request.steps.frames()) {
    if (!request.video.empty()) video_.emplace(request.video, request.size, request.fps);
    if (request.contact_sheet.has_parent_path()) make_writable_folder(request.contact_sheet.parent_path());
    folder_.make();
    folder_.clear();
  }

  void run(const InterruptGuard& interrupt) {
    try {
      make_frames(interrupt);
      manifest_.complete = manifest_.frames.size() == request_.steps.frames();
      save(manifest_, folder_.path());
    } catch (...) {
      manifest_.complete = false;
      save_what_is_there();
      throw;
    }
    if (!manifest_.complete) throw Interrupted(interruption());
    if (video_) video_->finish();
    if (!request_.contact_sheet.empty()) strip_.save(request_.contact_sheet);
  }

 private:
  void make_frames(const InterruptGuard& interrupt) {
    const StepRange& steps = request_.steps;
    FrameQueue queue(queue_capacity(request_.size), [this](FrameJob& job) { finish(job); });
    Progress progress(steps);
    std::uint32_t frames = 0;
    for (std::uint32_t step = 1; step <= steps.last && !interrupt.requested(); ++step) {
      film_->advance();
      if (step == steps.step_of(frames)) {
        queue.add({film_->draw(), film_->record()});
        ++frames;
      }
      progress.update(frames, step);
    }
    queue.finish();
    film_->finish();
  }

  /// Second thread. The record joins the manifest when its file is there.
  void finish(FrameJob& job) {
    const auto index = static_cast<std::uint32_t>(manifest_.frames.size());
    job.record.file = frame_file_name(manifest_.scene, index);
    job.record.pixel_hash = pixel_hash(job.image);
    write_png(folder_.path() / job.record.file, job.image);
    manifest_.frames.push_back(job.record);
    if (video_) video_->add(job.image.rgba);
    if (!request_.contact_sheet.empty()) strip_.offer(index, job.image);
  }

  /// After a failure: what went wrong first is what the user must hear, so errors here stay silent. On a full
  /// disk the last frames make room for the manifest.
  void save_what_is_there() noexcept {
    try {
      while (!save_or_drop_last_frame()) {
      }
    } catch (const std::exception&) {
      return;
    }
  }

  /// True if the manifest is saved; false if the disk was full and a frame was given up.
  bool save_or_drop_last_frame() {
    try {
      save(manifest_, folder_.path());
      return true;
    } catch (const std::system_error& error) {
      if (error.code() != std::errc::no_space_on_device || manifest_.frames.empty()) throw;
    }
    std::filesystem::remove(folder_.path() / manifest_.frames.back().file);
    manifest_.frames.pop_back();
    return false;
  }

  [[nodiscard]] std::string interruption() const {
    std::string text = "interrupted: " + std::to_string(manifest_.frames.size()) + " of " +
                       std::to_string(request_.steps.frames()) + " frames are in " + folder_.path().string();
    if (video_) text += "; no film was made";
    return text;
  }

  const RenderRequest& request_;
  SequenceFolder folder_;
  std::unique_ptr<Film> film_;
  Manifest manifest_;
  ContactStrip strip_;
  std::optional<Video> video_;
};

}  // namespace

void render_sequence(const RenderRequest& request) {
  check_free(request.video, request.overwrite);
  check_free(request.contact_sheet, request.overwrite);
  tune_allocator_for_rendering();
  const InterruptGuard interrupt;
  Sequence(request).run(interrupt);
}

}  // namespace kerf
