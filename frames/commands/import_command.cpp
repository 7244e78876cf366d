#include "frames/commands/import_command.h"

#include <CLI/CLI.hpp>

#include "frames/commands/import_boxes.h"
#include "frames/commands/output_option.h"
#include "frames/sequence/part_recording.h"
#include "frames/support/outputs.h"
#include "frames/support/parse_config.h"

namespace kerf {

ImportCommand::ImportCommand(CLI::App& program)
    : command_(program.add_subcommand("import", "Make a recording of another engine's boxes and pairs")) {
  const auto option = [this](const char* name, std::string& text, const char* meaning, const char* type) {
    return command_->add_option(name, text, meaning)->type_name(type);
  };
  option("FILE", boxes_, "Their boxes, see below", "")->required();
  add_output(*command_, "-o,--out", out_, "The recording")->required();
  option("--pairs", pairs_, "Their pairs: step,a,b", "FILE");
  option("--config", config_, "Parameters of our tree, see `kerf render --help`", "K=V,...");
  command_->add_flag("--overwrite", overwrite_, "Replace an earlier recording");
  command_->footer(
      "BOXES   step,object,min_x,max_x,min_y,max_y[,min_z,max_z][,fixed]   a heading may come first\n"
      "        Steps rise, objects are numbered from 0. A line adds an object or changes its box; where the\n"
      "        bounds are empty, the object goes. Objects without a line stay as they are. fixed is 0 or 1:\n"
      "        two fixed objects are no pair.\n"
      "        The first step becomes step 1.\n"
      "PAIRS   step,a,b   of the boxes' first step or a later one, also one after their last\n"
      "        What is wrong with them is then found by `kerf step FILE --to 'missed>0'` and `kerf "
      "explain`.");
}

bool ImportCommand::chosen() const { return command_->parsed(); }

void ImportCommand::run() const {
  ImportRequest request;
  request.boxes = boxes_;
  request.pairs = pairs_;
  request.config = parse_config("--config", config_, {});
  Outputs outputs({boxes_, pairs_}, overwrite_);
  outputs.add_recording(out_);
  PartRecording part(out_, outputs.replace());
  request.out = part.path();
  import_boxes(request);
  part.keep();
}

}  // namespace kerf
