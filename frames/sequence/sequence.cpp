#include "frames/sequence/sequence.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <string>
#include <system_error>

#include "core/base/counted.h"
#include "frames/sequence/farm/forked_crew.h"
#include "frames/sequence/farm/picture_maker.h"
#include "frames/sequence/farm/solo_crew.h"
#include "frames/sequence/film.h"
#include "frames/sequence/film_files.h"
#include "frames/sequence/manifest.h"
#include "frames/sequence/sequence_folder.h"
#include "frames/support/errors.h"
#include "frames/support/folder_lock.h"
#include "frames/support/interrupt.h"
#include "frames/support/outputs.h"
#include "frames/support/progress.h"
#include "viz/gl/context.h"

namespace kerf {
namespace {

std::size_t image_bytes(const RenderRequest& request) {
  if (!request.film.wants_any()) return 0;
  return 4 * static_cast<std::size_t>(request.size.width) * static_cast<std::size_t>(request.size.height);
}

/// The work on one sequence; the crew's thread uses `manifest_` and `files_` until it is done.
class Sequence {
 public:
  explicit Sequence(const RenderRequest& request)
      : request_(request),
        manifest_(begin_manifest(request)),
        lock_(lock_if_there(request.out)),
        folder_(request.out, manifest_.name),
        kept_(look_into_folder()),
        crew_(make_crew()),
        film_(make_film(request)),
        files_(request.film, request.size, request.steps.frames()) {
    take_folder();
  }

  void run(const InterruptGuard& interrupt) {
    try {
      make_frames(interrupt);
      folder_.remove_parts();
      manifest_.complete = manifest_.frames.size() == manifest_.wanted_frames();
      if (manifest_.complete) {
        folder_.finish(manifest_);
      } else {
        save(manifest_, folder_.path());
      }
    } catch (...) {
      keep_what_is_there();
      throw;
    }
    if (!manifest_.complete) throw Interrupted(interruption());
    if (!is_recorded_)
      throw Interrupted("interrupted: all frames are in " + folder_.path().string() + ", but " +
                        request_.record.string() +
                        " ends before the last step; the same command with --overwrite makes it whole");
    files_.finish();
  }

 private:
  static std::unique_ptr<FolderLock> lock_if_there(const std::filesystem::path& folder) {
    return std::filesystem::is_directory(folder) ? std::make_unique<FolderLock>(folder) : nullptr;
  }

  KeptFrames look_into_folder() {
    if (request_.resume)
      return request_.overwrite ? folder_.frames_begun_apart_of(manifest_) : folder_.frames_of(manifest_);
    folder_.check_free(request_.overwrite);
    folder_.build_apart_from_earlier();
    return {};
  }

  /// From here on files are written. Another process may have made the folder meanwhile and put frames into
  /// it.
  void take_folder() {
    folder_.make();
    if (lock_) return;
    lock_ = std::make_unique<FolderLock>(folder_.path());
    folder_.check_free(request_.resume);
  }

  std::unique_ptr<FrameCrew> make_crew() {
    RenderRequest request = request_;
    request.out = folder_.path();
    const auto start = [request = std::move(request)] { return make_picture_maker(request); };
    auto deliver = [this](const FrameRecord& record, const Image& image) { finish(record, image); };
    if (request_.workers == 0) return std::make_unique<SoloCrew>(start, std::move(deliver));
    const auto most = static_cast<int>(std::min<std::uint32_t>(manifest_.wanted_frames(), kMaxWorkers));
    return std::make_unique<ForkedCrew>(std::min(request_.workers, std::max(1, most)), image_bytes(request_),
                                        start, std::move(deliver));
  }

  void make_frames(const InterruptGuard& interrupt) {
    save_now_and_then();
    Progress progress(request_.steps);
    const auto go_on = [&](std::uint32_t step) {
      progress.update(finished_, step);
      return !interrupt.requested();
    };
    const StepRange& steps = request_.steps;
    for (std::uint32_t index = 0; index < steps.frames(); ++index) {
      if (!request_.shard.has(index)) continue;
      if (interrupt.requested() || !film_->advance_to(steps.step_of(index), go_on)) break;
      crew_->add(order(index));
    }
    crew_->finish();
    // A recording goes on to the last step, also when that is no frame.
    if (!request_.record.empty()) is_recorded_ = film_->advance_to(steps.last, go_on);
    film_->finish(is_recorded_ && !interrupt.requested());
  }

  FrameOrder order(std::uint32_t index) {
    FrameOrder order;
    order.parcel = film_->parcel();
    order.record = film_->record();
    order.record.index = index;
    order.record.file = frame_file_name(manifest_.name, index);
    const auto kept = kept_.find(index);
    if (kept != kept_.end()) order.kept = kept->second;
    order.wants_image = files_.wants(index);
    return order;
  }

  /// The crew's thread. The record joins the manifest when its file is there.
  void finish(const FrameRecord& record, const Image& image) {
    manifest_.frames.push_back(record);
    finished_ = static_cast<std::uint32_t>(manifest_.frames.size());
    if (files_.wants(record.index)) files_.add(record.index, image);
    save_now_and_then();
  }

  /// Lets a killed run be resumed. Takes a small part of the time, however long the manifest.
  void save_now_and_then() {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    if (start < next_save_) return;
    save(manifest_, folder_.path());
    const Clock::time_point end = Clock::now();
    next_save_ = end + std::max<Clock::duration>(std::chrono::seconds(1), 50 * (end - start));
  }

  /// After a failure: frames that are made are kept, unless they were to replace earlier ones.
  void keep_what_is_there() noexcept {
    crew_.reset();  // frames in flight are finished first
    film_->give_up();
    if (folder_.is_apart()) return folder_.give_up();
    folder_.remove_parts();
    manifest_.complete = false;
    save_what_is_there();
  }

  /// The user must see the first error, so errors here stay silent. On a full disk the last
  /// frames make room for the manifest.
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
    std::string text =
        "interrupted: " + counted_of(manifest_.frames.size(), manifest_.wanted_frames(), "frame") + " in " +
        folder_.path().string() + (folder_.is_apart() ? "; the earlier sequence is as it was" : "") +
        "; the same command with --resume" + (request_.record.empty() ? "" : ", and without --record,") +
        " makes the rest";
    if (files_.has_video()) text += "; no film was made";
    return text;
  }

  const RenderRequest& request_;
  Manifest manifest_;
  std::unique_ptr<FolderLock> lock_;  ///< null while there is no folder
  SequenceFolder folder_;
  KeptFrames kept_;                  ///< by an earlier run
  std::unique_ptr<FrameCrew> crew_;  ///< before the film, which may have threads
  std::unique_ptr<Film> film_;
  FilmFiles files_;
  bool is_recorded_ = true;  ///< to the last step, if requested
  std::atomic<std::uint32_t> finished_ = 0;
  std::chrono::steady_clock::time_point next_save_{};
};

void check_outputs(const RenderRequest& request) {
  Outputs outputs(
      {request.recording ? request.recording->path : std::filesystem::path(), request.camera_file},
      request.overwrite);
  outputs.add_folder(request.out);
  outputs.add_recording(request.record);
  add_outputs(request.film, outputs);
  const SequenceFolder frames(request.out, request.name);
  for (const std::filesystem::path& out : {request.record, request.film.video, request.film.contact_sheet})
    frames.check_apart(out);
}

}  // namespace

void render_sequence(const RenderRequest& request) {
  const InterruptGuard interrupt;  // before there is a file that an interrupt would leave
  check_outputs(request);
  tune_allocator_for_rendering();
  Sequence(request).run(interrupt);
}

}  // namespace kerf
