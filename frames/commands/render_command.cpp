#include <cstdio>
#include <string>

#include "core/base/counted.h"
#include "frames/commands/command.h"
#include "frames/sequence/render_request.h"
#include "frames/sequence/sequence.h"

namespace kerf {
namespace {

std::string layer_names() { return to_string(LayerSet::all()); }

template <int D>
std::string names_of() {
  constexpr std::size_t kColumns = 100;
  std::string names;
  std::size_t used = 0;
  for (const std::string& name : broad_phase_names<D>()) {
    const bool is_full = used + name.size() > kColumns;
    names += (names.empty() ? "" : is_full ? ",\n      " : ", ") + name;
    used = (is_full ? 0 : used) + name.size() + 2;
  }
  return names;
}

/// Explanations that do not fit into a line of an option.
std::string render_footer() {
  std::string text =
      "LAYERS  " + layer_names() +
      "\n        a list of these, 'all' or 'none', or changes such as +leaves,-legend\nSTEPS   of imports as "
      "the other engine numbers them; dates, which have colons themselves: A..B..N\nCAMERA  3D: "
      "yaw=30,pitch=25,fov=35,distance=40,target=0:0:0   2D: center=0:5,width=40\n        3D also top, "
      "front, side or iso: --camera iso,fov=20\n        any part of it; what is left out is chosen so that "
      "what most objects span is seen, and the\n        caption says how many lie outside. With 'all' "
      "everything is: --camera all or all,yaw=60\nPATH    a key frame a line: a step and what is said of the "
      "camera from then on, 120 yaw=90,pitch=20\n        between them it moves smoothly; what follows a # is "
      "a remark\nSAMPLES 1: jagged edges; 4: smooth ones, three times slower; 2x2: drawn at twice the size "
      "and averaged\nOUTPUT  DIR/SCENE_000000.png and so on, and DIR/frames.json, which says what each frame "
      "shows.\n        A folder that holds a sequence is refused unless --overwrite is given, which replaces "
      "that\n        sequence, when the new one is complete, and nothing else. Ctrl-C keeps the finished "
      "frames\n        and their manifest; the same command with --resume makes the rest.\n\nBROAD PHASES "
      "for --broad-phase: kerf is the tuned tree, kerf-paper the tree with the paper's parameters\n  3D  " +
      names_of<3>() + "\n  2D  " + names_of<2>() +
      "\n\nVOLUMES for --volume: box, sphere, oriented-box; in 3D 14-dop, 26-dop; in 2D 8-dop, "
      "16-dop\n\nPARAMETERS of the tree for --config, with the paper's values. kerf-paper in a scene that "
      "needs no free\n           directions starts with free_directions=0, kerf with its own; frames.json "
      "says what was used:\n";
  for (const ConfigField& field : config_fields()) {
    std::string line = "  " + std::string(field.name) + "=" + get(Config{}, field.name);
    line.resize(std::max<std::size_t>(line.size() + 1, 28), ' ');
    text += line + std::string(field.meaning) + "\n";
  }
  return text;
}

class RenderCommand final : public Command {
 public:
  explicit RenderCommand(CLI::App& program);
  void run() const override;

 private:
  RenderTexts texts_;
};

RenderCommand::RenderCommand(CLI::App& program)
    : Command(program, "render", "Run a scene, or a recording again, and draw it as a sequence of frames") {
  option("SCENE", texts_.scene, "A scene of `kerf scenes`, or the file of a recording", "")->required();
  option("--steps", texts_.steps, "From step A to B a frame every N steps (default 1:1000:4)", "A:B:N");
  option("--size", texts_.size, "Width and height in pixels (default 1280x720)", "WxH");
  option("--objects", texts_.objects, "Moving objects at the end (default: the scene's own)", "N");
  option("--grow", texts_.grow, "Steps until all objects are there (default: the scene's own)", "STEPS");
  option("--recycle", texts_.recycle,
         "Then let the oldest fall anew, one every so many steps (default never)", "STEPS");
  option("--broad-phase", texts_.broad_phase, "What finds the pairs, see below (default kerf-paper)", "NAME");
  option("--beside", texts_.beside,
         "Up to five more broad phases on the same boxes, each in a pane with its structure; or none",
         "NAME,...");
  command_->add_flag("--timed", texts_.timed,
                     "Panes also show what a step takes; two runs then do not have the same pixels");
  option("--volume", texts_.volume, "How objects are bounded, see below (default: what the scene needs)",
         "KIND");
  option("--show", texts_.show, "What is drawn, see below (default all)", "LAYERS");
  option("--view", texts_.view, "3D: from which side: iso, top, front or side", "NAME");
  option("--camera", texts_.camera, "From where, see below (default: most in view)", "TEXT");
  option("--camera-path", texts_.camera_path, "Camera that moves, from a file, see below", "FILE");
  option("--samples", texts_.samples, "Of each pixel, see below (default: 4, of many objects 1)", "1|4|2x2");
  option("--backend", texts_.backend,
         "What draws, in the same pixels (default any: osmesa, or egl where it is missing)",
         "any|osmesa|egl");
  option("--config", texts_.config, "Parameters of the tree, see below (default: those of --broad-phase)",
         "K=V,...");
  output("--out", texts_.out, "Folder for frames and manifest (default out/SCENE)", "DIR");
  output("--video", texts_.video, "Also a film (.mp4, .mkv, .mov, .webm, .gif, .apng), by ffmpeg");
  option("--fps", texts_.fps, "Frames a second of the film (default 25)", "N");
  output("--contact-sheet", texts_.contact_sheet, "Also twenty of the frames in one .png");
  option("--seed", texts_.seed, "Of every random choice of the scene (default 1)", "S");
  output("--record", texts_.record, "Also a recording for `kerf verify` and the like");
  option("--workers", texts_.workers, "Processes that draw; 0: this one alone (default: one a core)", "N");
  option("--shard", texts_.shard, "Of a recording: only every N-th frame, the K-th first", "K/N");
  command_->add_flag(
      "--ids", texts_.ids,
      "Also FRAME.ids.png and FRAME.draw.json: which plane, leaf or pair is where, for kerf diff");
  command_->add_flag("--resume", texts_.resume, "Keep the frames that an interrupted render has left");
  command_->add_flag("--overwrite", texts_.overwrite,
                     "Replace an earlier sequence, film, contact sheet and recording");
  command_->footer(render_footer());
}

void RenderCommand::run() const {
  const RenderRequest request =
      names_recording(texts_) ? parse_recording_request(texts_) : parse_request(texts_);
  render_sequence(request);
  const Shard& shard = request.shard;
  const std::uint32_t frames = (request.steps.frames() + shard.count - 1 - shard.index) / shard.count;
  std::string files = request.out.string() + ": " + counted(frames, "frame");
  for (const std::filesystem::path& file : {request.film.video, request.film.contact_sheet, request.record})
    if (!file.empty()) files += ", " + file.string();
  std::puts(files.c_str());
}

}  // namespace

AnyCommand make_render_command(CLI::App& program) { return std::make_unique<RenderCommand>(program); }

}  // namespace kerf
