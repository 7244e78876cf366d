#include "frames/export_command.h"

#include <CLI/CLI.hpp>
#include <cerrno>
#include <fstream>
#include <iostream>
#include <system_error>

#include "frames/errors.h"
#include "frames/export_recording.h"
#include "frames/recording_file.h"

namespace kerf {
namespace {

/// Of what was tried last.
[[noreturn]] void fail_to_write(const std::string& file) {
  throw std::system_error(errno, std::generic_category(), "cannot write " + file);
}

}  // namespace

ExportCommand::ExportCommand(CLI::App& program)
    : command_(program.add_subcommand("export", "Write a recording for other programs")) {
  command_->add_option("FILE", file_, "A recording")->type_name("")->required();
  auto* const format = command_->add_option_group("format");
  format->add_flag("--chrome-trace", chrome_trace_, "Phases, operators and counters as a timeline (JSON)");
  format->add_flag("--csv", csv_, "A line for each step, with all its figures");
  format->add_flag("--boxes", boxes_,
                   "A line for each box that came, went or changed: what `kerf import` reads");
  format->require_option(1);
  command_->add_option("-o,--out", out_, "Where to (default: standard output)")->type_name("FILE");
  command_->footer("A timeline is shown by chrome://tracing and https://ui.perfetto.dev.");
}

bool ExportCommand::chosen() const { return command_->parsed(); }

void ExportCommand::run() const {
  std::ofstream file;
  if (!out_.empty()) file.open(out_);
  std::ostream& out = out_.empty() ? std::cout : file;
  if (!out) fail_to_write(out_);
  with_recording(file_, [&](auto recording) {
    if (chrome_trace_) export_chrome_trace(*recording, out);
    if (csv_) export_steps(*recording, out);
    if (boxes_) export_boxes(*recording, out);
  });
  out.flush();
  if (!out) fail_to_write(out_.empty() ? "to standard output" : out_);
}

}  // namespace kerf
