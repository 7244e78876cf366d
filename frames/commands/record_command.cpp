#include <string>

#include "frames/commands/command.h"
#include "frames/sequence/record_scene.h"
#include "frames/sequence/render_request.h"
#include "frames/support/errors.h"

namespace kerf {
namespace {

class RecordCommand final : public Command {
 public:
  explicit RecordCommand(CLI::App& program);
  void run() const override;

 private:
  RenderTexts texts_;
};

RecordCommand::RecordCommand(CLI::App& program)
    : Command(program, "record", "Run a scene and record every step of its tree") {
  option("SCENE", texts_.scene, "A scene of `kerf scenes`", "")->required();
  output("-o,--out", texts_.record, "The recording, for example pile.kerf")->required();
  option("--steps", texts_.steps, "How many (default 1000)", "N");
  option("--objects", texts_.objects, "Moving objects at the end (default: the scene's own)", "N");
  option("--grow", texts_.grow, "Steps until all objects are there (default: the scene's own)", "STEPS");
  option("--recycle", texts_.recycle,
         "Then let the oldest fall anew, one every so many steps (default never)", "STEPS");
  option("--volume", texts_.volume, "How objects are bounded (default: what the scene needs)", "KIND");
  option("--broad-phase", texts_.broad_phase, "kerf-paper (default) or kerf, the tuned tree", "NAME");
  option("--config", texts_.config, "Parameters of the tree, see `kerf render --help`", "K=V,...");
  option("--seed", texts_.seed, "Of every random choice of the scene (default 1)", "S");
  command_->add_flag("--overwrite", texts_.overwrite, "Replace an earlier recording");
  command_->footer(
      "The file is an SQLite database (docs/RECORDING.md). While it is made, and if the program is killed,\n"
      "it is called FILE.NUMBER.part and has all but the last second. Commands read it by the name FILE as\n"
      "long as there is no FILE.");
}

void RecordCommand::run() const {
  check_recorded_steps(texts_.steps);
  record_scene(parse_request(texts_));
}

}  // namespace

AnyCommand make_record_command(CLI::App& program) { return std::make_unique<RecordCommand>(program); }

}  // namespace kerf
