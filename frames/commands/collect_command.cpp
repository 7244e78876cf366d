#include <cstdio>
#include <string>
#include <vector>

#include "core/base/counted.h"
#include "frames/commands/command.h"
#include "frames/sequence/collection.h"
#include "frames/sequence/film_files.h"
#include "frames/sequence/sequence_folder.h"
#include "frames/support/errors.h"
#include "frames/support/interrupt.h"
#include "frames/support/outputs.h"
#include "frames/support/progress.h"

namespace kerf {
namespace {

class CollectCommand final : public Command {
 public:
  explicit CollectCommand(CLI::App& program);
  void run() const override;

 private:
  std::vector<std::string> folders_;
  std::string out_;
  std::string video_;
  std::string fps_;
  std::string contact_sheet_;
  bool overwrite_ = false;
};

CollectCommand::CollectCommand(CLI::App& program)
    : Command(program, "collect", "Check the shards of a sequence and put them together") {
  option("DIR", folders_, "The folders of all shards", "")->required();
  output("--out", out_, "Put all frames and one manifest here", "DIR");
  output("--video", video_, "Make a film (.mp4, .mkv, .mov, .webm, .gif, .apng), by ffmpeg");
  option("--fps", fps_, "Frames a second of the film (default 25)", "N");
  output("--contact-sheet", contact_sheet_, "Put twenty of the frames into one .png");
  command_->add_flag("--overwrite", overwrite_, "Replace an earlier sequence, film and contact sheet");
  command_->footer(
      "Every picture is read and held against its manifest, and what --ids put beside it is read. What is\n"
      "missing or damaged is said, and the command that makes it.");
}

void CollectCommand::run() const {
  const FilmRequest film = parse_film_request(video_, fps_, contact_sheet_, overwrite_);
  const std::vector<std::filesystem::path> folders(folders_.begin(), folders_.end());
  Outputs outputs(folders, overwrite_);
  outputs.add_folder(out_);
  add_outputs(film, outputs);
  const InterruptGuard interrupt;
  Collection collection = collect(folders);
  const std::string gaps = describe_gaps(collection);
  if (!gaps.empty()) throw DoesNotHold(gaps);
  const Manifest& manifest = collection.manifest;
  if (!out_.empty())
    for (const std::filesystem::path& out : {film.video, film.contact_sheet})
      SequenceFolder(out_, manifest.name).check_apart(out);
  FilmFiles files(film, manifest.size, manifest.steps.frames());
  const ProgressLine progress;
  BadFrames bad(collection);
  for (CollectedFrame& frame : collection.frames) {
    if (interrupt.requested()) throw Interrupted("interrupted");
    progress.show("frame " + std::to_string(frame.record.index + 1) + "/" +
                  std::to_string(manifest.steps.frames()));
    Image image;
    const std::string trouble = trouble_with(frame, collection.has_ids, image);
    if (!trouble.empty()) bad.add(frame.record.index, trouble);
    if (bad.empty()) files.add(frame.record.index, image);
  }
  progress.clear();
  if (!bad.empty()) throw DoesNotHold(bad.describe());
  if (!out_.empty()) gather(collection, out_, overwrite_);
  files.finish();
  const std::size_t frames = collection.frames.size();
  std::printf("%s: %s there, from %s\n", manifest.name.c_str(),
              (frames == 1 ? "its only frame is" : "all " + counted(frames, "frame") + " are").c_str(),
              counted(collection.folders, "folder").c_str());
}

}  // namespace

AnyCommand make_collect_command(CLI::App& program) { return std::make_unique<CollectCommand>(program); }

}  // namespace kerf
