#include <cstdio>

#include "core/base/counted.h"
#include "frames/commands/command.h"
#include "frames/story/story.h"
#include "frames/story/story_request.h"

namespace kerf {
namespace {

class FilmCommand final : public Command {
 public:
  explicit FilmCommand(CLI::App& program);
  void run() const override;

 private:
  StoryTexts texts_;
};

FilmCommand::FilmCommand(CLI::App& program)
    : Command(program, "film", "A short film of a run, to share: scene, tree and tests") {
  RenderTexts& texts = texts_.pictures;
  option("SCENE|FILE", texts.scene, "A scene of `kerf scenes`, or a recording", "")->required();
  output("-o,--out", texts.video, "The film (.mp4, .mkv, .mov, .webm, .gif, .apng)")->required();
  output("--still", texts_.still, "Also its picture of the largest operator, a .png");
  option("--seconds", texts_.seconds, "How long it is (default 60)", "N");
  option("--fps", texts.fps, "Frames a second (default 60)", "N");
  option("--size", texts.size, "Width and height in pixels (default 1920x1080)", "WxH");
  option("--steps", texts.steps, "Of a scene how many (default 800), of a recording which (default all)",
         "A:B");
  option("--beside", texts_.beside, "The second curve: loose-octree (default), sweep-and-prune or none",
         "NAME");
  option("--objects", texts.objects, "Of a scene: moving objects at the end (default: its own)", "N");
  option("--grow", texts.grow, "Of a scene: steps until all objects are there", "STEPS");
  option("--broad-phase", texts.broad_phase, "Of a scene: kerf-paper (default) or kerf, the tuned tree",
         "NAME");
  option("--config", texts.config, "Of a scene: parameters of the tree, see `kerf render --help`", "K=V,...");
  option("--seed", texts.seed, "Of a scene: of every random choice (default 1)", "S");
  option("--show", texts.show, "Layers (default objects,leaves,partitioners,operators)", "LAYERS");
  option("--view", texts.view, "3D: from which side, in the middle of the film: iso, top, front or side",
         "NAME");
  option("--camera", texts.camera, "From where, in the middle of the film, see `kerf render --help`", "TEXT");
  option("--workers", texts.workers, "Processes that draw; 0: this one alone (default: one a core)", "N");
  command_->add_flag("--overwrite", texts.overwrite, "Replace an earlier film and picture");
  command_->footer(
      "The scene is on the left; the camera goes slowly around it. On the right are the tree as an icicle\n"
      "(a bar is as wide as its node has objects) and the tests that each broad phase makes, step by step.\n"
      "Time stands still at the operators on the largest nodes, while their planes move.");
}

void FilmCommand::run() const {
  const StoryRequest request = parse_story_request(texts_);
  make_story(request);
  const std::string still = request.still.empty() ? "" : ", " + request.still.string();
  std::printf("%s: %s%s\n", request.pictures.film.video.c_str(), counted(request.frames, "frame").c_str(),
              still.c_str());
}

}  // namespace

AnyCommand make_film_command(CLI::App& program) { return std::make_unique<FilmCommand>(program); }

}  // namespace kerf
