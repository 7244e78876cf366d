#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string>

#include "core/base/counted.h"
#include "core/replay/what_if.h"
#include "frames/commands/command.h"
#include "frames/sequence/part_recording.h"
#include "frames/sequence/recording_file.h"
#include "frames/support/errors.h"
#include "frames/support/interrupt.h"
#include "frames/support/outputs.h"
#include "frames/support/parse_config.h"
#include "frames/support/parse_number.h"

namespace kerf {
namespace {

/// An event, and the index of one of its candidates; none: refuse it.
struct EventChoice {
  std::uint64_t event = 0;
  std::optional<std::size_t> candidate;
};

/// "e123", and with candidate "e123:2".
EventChoice parse_choice(const std::string& option, const std::string& text, bool with_candidate) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  const auto event = text.starts_with("e")
                         ? parse_number<std::uint64_t>(std::string_view(text).substr(1, colon - 1))
                         : std::nullopt;
  std::optional<std::size_t> candidate;
  if (colon < text.size()) candidate = parse_number<std::size_t>(std::string_view(text).substr(colon + 1));
  if (!event || candidate.has_value() != with_candidate || (colon < text.size()) != with_candidate)
    throw UsageError(option + " '" + text + "' is not an event " +
                     (with_candidate ? "with a candidate, for example e1234:2" : "such as e1234"));
  return {*event, candidate};
}

/// The change given on the command line.
struct WhatIf {
  std::string config;
  std::string from;  ///< the first step with it; empty: the first of all
  std::optional<EventChoice> decision;
  std::filesystem::path out;
  Replace replace = Replace::nothing;
};

template <int D>
std::uint32_t first_step(const RecordingReader<D>& recording, const std::string& from) {
  if (from.empty()) return 1;
  const Position position = parse_position("--from", from, recording);
  if (!position.is_end()) throw UsageError("--from '" + from + "' is no step");
  return position.step;
}

template <int D>
RecordingInfo what_if(const std::shared_ptr<RecordingReader<D>>& recording, const WhatIf& asked) {
  RecordingInfo info = recording->info();
  const std::uint32_t from = first_step(*recording, asked.from);
  try {
    Replayer<D> replayer(recording);
    if (asked.decision) decide(info, replayer, asked.decision->event, asked.decision->candidate);
    const Config config = parse_config("--config", asked.config, config_of(info, from));
    if (!asked.config.empty()) change_config(info, *recording, from, config);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  return info;
}

template <int D>
void rerun_recording(const std::shared_ptr<RecordingReader<D>>& recording, const WhatIf& asked) {
  const RecordingInfo info = what_if(recording, asked);
  const InterruptGuard interrupt;
  PartRecording part(asked.out, asked.replace);
  bool whole = false;
  const std::filesystem::path file = part.write([&] {
    whole = rerun(*recording, info, part.path(), [&] { return interrupt.requested(); });
    if (!whole) return part.keep_as_far_as_it_came();
    part.keep();
    return asked.out;
  });
  std::printf("%s: %s\n", file.c_str(), counted(RecordingReader<D>(file).steps(), "step").c_str());
  if (!whole) throw Interrupted("interrupted: what was done is in " + file.string());
}

class RerunCommand final : public Command {
 public:
  explicit RerunCommand(CLI::App& program);
  void run() const override;

 private:
  std::string file_;
  std::string out_;
  std::string config_;
  std::string from_;
  std::string refuse_;
  std::string take_;
  bool overwrite_ = false;
};

RerunCommand::RerunCommand(CLI::App& program)
    : Command(program, "rerun",
              "What if? Record the boxes of a recording again, with another configuration or decision") {
  option("FILE", file_, "A recording", "")->required();
  output("-o,--out", out_, "The new recording")->required();
  option("--config", config_, "Parameters that change, see `kerf render --help`", "K=V,...");
  option("--from", from_, "The first step in which --config holds (default: the first)", "STEP");
  auto* refuse = option("--refuse", refuse_, "The operator of this event does not act", "EVENT");
  option("--take", take_, "The split of this event divides by that candidate of its ballot", "EVENT:K")
      ->excludes(refuse);
  command_->add_flag("--overwrite", overwrite_, "Replace an earlier recording");
  command_->footer(
      "`kerf compare` then shows the first operator that differs, and the figures of both. A refusal holds\n"
      "once: Algorithm 1 goes on with what it does where that operator fails. A rerun is a recording of its\n"
      "own, on which the next decision can be made.");
}

void RerunCommand::run() const {
  Outputs outputs({file_}, overwrite_);
  outputs.add_recording(out_);
  WhatIf asked{config_, from_, std::nullopt, out_, outputs.replace()};
  if (!refuse_.empty()) asked.decision = parse_choice("--refuse", refuse_, false);
  if (!take_.empty()) asked.decision = parse_choice("--take", take_, true);
  if (config_.empty() && !from_.empty())
    throw UsageError("--from says where --config begins: give that, too");
  (void)parse_config("--config", config_, read_recording_info(file_).config);
  with_recording(file_, [&](auto recording) { rerun_recording(recording, asked); });
}

}  // namespace

AnyCommand make_rerun_command(CLI::App& program) { return std::make_unique<RerunCommand>(program); }

}  // namespace kerf
