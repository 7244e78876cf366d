#include <iostream>
#include <string>

#include "core/base/poll.h"
#include "frames/commands/command.h"
#include "frames/commands/export_recording.h"
#include "frames/sequence/recording_file.h"
#include "frames/support/errors.h"
#include "frames/support/interrupt.h"
#include "frames/support/outputs.h"
#include "frames/support/result_file.h"

namespace kerf {
namespace {

template <int D>
bool has_their_pairs(const RecordingReader<D>& recording) {
  return recording.steps() > 0 && recording.their_step(1).has_value();
}

class ExportCommand final : public Command {
 public:
  explicit ExportCommand(CLI::App& program);
  void run() const override;

 private:
  std::string file_;
  std::string out_;
  bool chrome_trace_ = false;
  bool csv_ = false;
  bool boxes_ = false;
  bool pairs_ = false;
  bool overwrite_ = false;
};

ExportCommand::ExportCommand(CLI::App& program)
    : Command(program, "export", "Write a recording for other programs") {
  option("FILE", file_, "A recording", "")->required();
  auto* const format = command_->add_option_group("format");
  format->add_flag("--chrome-trace", chrome_trace_, "Phases, operators and counters as a timeline (JSON)");
  format->add_flag("--csv", csv_, "A line for each step, with all its figures");
  format->add_flag("--boxes", boxes_,
                   "A line for each box that came, went or changed: what `kerf import` reads");
  format->add_flag("--pairs", pairs_,
                   "A line for each pair of another engine: what `kerf import --pairs` reads");
  format->require_option(1);
  output("-o,--out", out_, "Where to (default, and -: standard output)");
  command_->add_flag("--overwrite", overwrite_, "Replace an earlier file");
  command_->footer("A timeline is shown by chrome://tracing and https://ui.perfetto.dev.");
}

void ExportCommand::run() const {
  const auto write = [this](auto& recording, std::ostream& out, const OnStep& on_step) {
    if (chrome_trace_) export_chrome_trace(recording, out, on_step);
    if (csv_) export_steps(recording, out, on_step);
    if (boxes_) export_boxes(recording, out, on_step);
    if (pairs_ && !has_their_pairs(recording))
      throw UsageError(file_ + " has no pairs of another engine; `kerf import --pairs` brings them");
    if (pairs_) export_pairs(recording, out, on_step);
  };
  if (out_.empty() || out_ == "-") {
    with_recording(file_, [&](auto recording) { write(*recording, std::cout, [](std::uint32_t) {}); });
    return;
  }
  Outputs outputs({file_}, overwrite_);
  outputs.add_file(out_);
  with_recording(file_, [&](auto recording) {
    const InterruptGuard interrupt;
    const Polling polling([&] {
      if (interrupt.requested()) throw Interrupted("interrupted; nothing was written");
    });
    PartStream file(out_, outputs.replace());
    write(*recording, file.stream(), [&](std::uint32_t) {
      file.check();
      poll();
    });
    file.keep();
  });
}

}  // namespace

AnyCommand make_export_command(CLI::App& program) { return std::make_unique<ExportCommand>(program); }

}  // namespace kerf
