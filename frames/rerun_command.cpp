#include "frames/rerun_command.h"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "core/recording/recorder.h"
#include "frames/errors.h"
#include "frames/interrupt.h"
#include "frames/parse_config.h"
#include "frames/recording_file.h"

namespace kerf {
namespace {

template <int D>
void rerun(RecordingReader<D>& recording, const Config& config, const std::filesystem::path& out) {
  const InterruptGuard interrupt;
  RecordingInfo info = recording.info();
  info.config = config;
  Bsp<D, EventLog> tree(config, info.volume);
  Recorder<D> recorder(tree, out, info);
  for (std::uint32_t step = 1; step <= recording.steps() && !interrupt.requested(); ++step) {
    apply(recording.step(step).requests, recorder);
    recorder.step();
    (void)tree.trace().take();
    if (const auto theirs = recording.their_step(step))
      recorder.add_theirs(recording.their_pairs(step), *theirs);
  }
  recorder.finish();
  std::printf("%s: %u steps\n", out.c_str(), tree.steps());
  if (tree.steps() < recording.steps()) throw Interrupted("interrupted: what was done is in " + out.string());
}

}  // namespace

RerunCommand::RerunCommand(CLI::App& program)
    : command_(program.add_subcommand("rerun",
                                      "Record the boxes of a recording again, with another configuration")) {
  command_->add_option("FILE", file_, "A recording")->type_name("")->required();
  command_->add_option("-o,--out", out_, "The new recording")->type_name("FILE")->required();
  command_->add_option("--config", config_, "Parameters that change, see `kerf render --help`")
      ->type_name("K=V,...");
  command_->add_flag("--overwrite", overwrite_, "Replace an earlier recording");
  command_->footer(
      "What if? `kerf compare` then shows the first operator that is another one, and the figures of both.");
}

bool RerunCommand::chosen() const { return command_->parsed(); }

void RerunCommand::run() const {
  const RecordingInfo info = read_recording_info(file_);
  const Config config = parse_config("--config", config_, info.config);
  std::error_code ignored;
  if (std::filesystem::equivalent(file_, out_, ignored))
    throw UsageError("--out is the recording itself; choose another name");
  clear_recording_path(out_, overwrite_);
  with_recording(file_, [&](auto recording) { rerun(*recording, config, out_); });
}

}  // namespace kerf
