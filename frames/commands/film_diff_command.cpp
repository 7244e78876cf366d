#include <cstdio>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/base/counted.h"
#include "core/base/given_names.h"
#include "frames/commands/command.h"
#include "frames/sequence/difference_panels.h"
#include "frames/sequence/film_files.h"
#include "frames/sequence/manifest.h"
#include "frames/support/atomic_file.h"
#include "frames/support/errors.h"
#include "frames/support/interrupt.h"
#include "frames/support/outputs.h"
#include "frames/support/progress.h"
#include "viz/image/png.h"

namespace kerf {
namespace {

constexpr int kPanelWidth = 640;

struct FrameOfStep {
  std::string step;  ///< as the caption shows it
  std::filesystem::path path;
};

/// By the number or time of the step.
using FramesByStep = std::map<long double, FrameOfStep>;

FramesByStep frames_of(const std::filesystem::path& folder) {
  FramesByStep frames;
  for (const FrameRecord& frame : read_manifest(folder).frames) {
    const std::string step = frame.given_step.empty() ? std::to_string(frame.step) : frame.given_step;
    const auto time = parse_step_time(step);
    if (!time)
      throw UsageError((folder / kManifestName).string() + ": '" + step +
                       "' is no step; render the frames anew");
    frames.emplace(*time, FrameOfStep{step, folder / frame.file});
  }
  return frames;
}

struct Couple {
  std::filesystem::path a;
  std::filesystem::path b;
};

/// The pictures of the steps that both have.
std::vector<Couple> common_frames(const FramesByStep& a, const FramesByStep& b) {
  std::vector<Couple> common;
  for (const auto& [time, frame] : a)
    if (const auto other = b.find(time); other != b.end()) common.push_back({frame.path, other->second.path});
  return common;
}

/// Names the frames of `frames` whose step `other` has not; returns how many there are.
std::size_t report_without_partner(const std::string& folder, const FramesByStep& frames,
                                   const FramesByStep& other) {
  std::size_t count = 0;
  for (const auto& [time, frame] : frames) {
    if (other.contains(time)) continue;
    ++count;
    std::printf("%s: step %s is in %s alone\n", frame.path.filename().c_str(), frame.step.c_str(),
                folder.c_str());
  }
  return count;
}

Image panels_of(const std::filesystem::path& a, const std::filesystem::path& b, std::size_t& differing) {
  try {
    return difference_panels(read_png(a), read_png(b), kPanelWidth, differing);
  } catch (const std::invalid_argument& error) {
    throw UsageError(a.string() + " and " + b.string() + ": " + error.what() + "; render both in one --size");
  }
}

class FilmDiffCommand final : public Command {
 public:
  explicit FilmDiffCommand(CLI::App& program);
  void run() const override;

 private:
  std::string a_;
  std::string b_;
  std::string out_;
  std::string fps_;
  std::string contact_sheet_;
  bool overwrite_ = false;
};

FilmDiffCommand::FilmDiffCommand(CLI::App& program)
    : Command(program, "film-diff", "Two sequences side by side, with what differs, as a film") {
  option("A", a_, "Folder of a sequence", "")->required();
  option("B", b_, "Folder of another one", "")->required();
  output("-o,--out", out_, "The film (.mp4, .mkv, .mov, .webm, .gif, .apng)")->required();
  option("--fps", fps_, "Frames a second (default 25)", "N");
  output("--contact-sheet", contact_sheet_, "Also twenty of the pictures in one .png");
  command_->add_flag("--overwrite", overwrite_, "Replace an earlier film and contact sheet");
  command_->footer(
      "A is left, B in the middle; right of them A is shown pale, with what differs in red: the more, the "
      "redder.\n"
      "Frames of equal steps are compared, of imports by the other engine's numbers. `kerf diff` judges "
      "pictures.");
}

void FilmDiffCommand::run() const {
  const InterruptGuard interrupt;  // before there is a file that an interrupt would leave
  const FilmRequest film = parse_film_request(out_, fps_, contact_sheet_, overwrite_);
  Outputs outputs({a_, b_}, overwrite_);
  add_outputs(film, outputs);
  make_writable_folder(std::filesystem::absolute(film.video).parent_path());
  const FramesByStep a = frames_of(a_);
  const FramesByStep b = frames_of(b_);
  const auto frames = common_frames(a, b);
  if (frames.empty()) throw UsageError(a_ + " and " + b_ + " have no frames of equal steps");
  const ProgressLine progress;
  std::optional<FilmFiles> files;
  std::uint32_t index = 0;
  std::uint32_t different = 0;
  for (const Couple& couple : frames) {
    if (interrupt.requested()) throw Interrupted("interrupted; no film was made");
    progress.show("frame " + std::to_string(index + 1) + "/" + std::to_string(frames.size()));
    std::size_t differing = 0;
    const Image image = panels_of(couple.a, couple.b, differing);
    if (!files)
      files.emplace(film, PictureSize{image.width, image.height}, static_cast<std::uint32_t>(frames.size()));
    files->add(index++, image);
    if (differing > 0) ++different;
  }
  files->finish();
  progress.clear();
  std::printf("%s: %s, %u of them different\n", out_.c_str(), counted(frames.size(), "frame").c_str(),
              different);
  const std::size_t alone = report_without_partner(a_, a, b) + report_without_partner(b_, b, a);
  if (alone > 0)
    throw DoesNotHold(counted(alone, "frame has", "frames have") + " no partner and " +
                      (alone == 1 ? "is" : "are") + " not in the film");
}

}  // namespace

AnyCommand make_film_diff_command(CLI::App& program) { return std::make_unique<FilmDiffCommand>(program); }

}  // namespace kerf
