#include "frames/commands/debug_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>

#include "frames/commands/output_option.h"
#include "frames/commands/window_keeper.h"
#include "frames/sequence/record_scene.h"
#include "frames/support/atomic_file.h"
#include "frames/support/errors.h"
#include "frames/support/interrupt.h"
#include "frames/support/outputs.h"
#include "frames/support/parse_number.h"
#include "frames/support/scratch_folder.h"
#include "viz/debugger/debugger.h"
#include "viz/debugger/gui/glfw_window.h"
#include "viz/debugger/script.h"
#include "viz/debugger/window_loop.h"
#include "viz/gl/context.h"
#include "viz/image/png.h"

namespace kerf {
namespace {

constexpr const char* kSceneOfTour = "pile";

constexpr const char* kDebugFooter =
    "SCENE is recorded first, into a temporary file; FILE is what `kerf record` or `kerf import` wrote.\n"
    "In the window, F1 shows the keys. docs/DEBUGGING.md is a guide, and has the commands of scripts.";

std::string read_script(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw UsageError("--script: " + path + " cannot be read");
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Of the pictures whose names a script says, each once: it may replace its own.
void add_pictures(const std::vector<ScriptLine>& lines, const std::filesystem::path& folder,
                  Outputs& outputs) {
  std::set<std::string> names;
  for (const ScriptLine& line : lines)
    if (line.words.size() > 1 && line.words[0] == "screenshot") names.insert(line.words[1]);
  outputs.add_folder(folder);
  for (const std::string& name : names) outputs.add_file(folder / (name + ".png"));
}

/// What one sitting with the debugger needs.
struct Session {
  std::filesystem::path file;
  std::string name;      ///< as the user named it
  bool is_tour = false;  ///< of a scene of our own, since none was named
  std::filesystem::path work_folder;
  PictureFolder pictures;
  PictureSize size;
  bool grows = false;             ///< with the display: no size was asked for
  std::optional<double> scale{};  ///< pixels in a unit of the panels, if given
  std::optional<ThemeName> theme{};
  std::optional<std::filesystem::path> window_file{};  ///< layout, zoom and theme from start to start
};

void play_headless(const Session& session, const std::vector<ScriptLine>& lines) {
  const auto context = make_offscreen_context();
  Debugger debugger(*context, open_run(session.file));
  debugger.model().work_folder = session.work_folder;
  if (session.scale) debugger.set_content_scale(*session.scale);
  WindowKeeper keeper(debugger, session.window_file, session.theme);
  ScriptPlayer(debugger, session.size.width, session.size.height, session.pictures).play(lines);
  keeper.keep();
}

void save_picture(Debugger& debugger, const PictureFolder& folder) {
  const auto path = folder.path / (debugger.facts()["position"] + ".png");
  try {
    Outputs({}, folder.replace == Replace::earlier).add_file(path);
    std::filesystem::create_directories(folder.path);
    write_png(path, debugger.picture(), folder.replace);
    debugger.report("saved " + path.string(), false);
  } catch (const std::exception& error) {
    debugger.report(error.what(), true);
  }
}

void show_window(const Session& session, const std::vector<ScriptLine>& lines) {
  const InterruptGuard interrupt;
  std::unique_ptr<Run> run = open_run(session.file);
  const std::string title = run->info().scene + " - kerf debug " + session.name;
  GlfwWindow window(title, session.size.width, session.size.height, session.grows);
  Debugger debugger(window, std::move(run));
  debugger.model().work_folder = session.work_folder;
  debugger.model().on_long_work = [&](std::uint32_t step) {
    const bool goes_on =
        window.goes_on("step " + debugger.model().run().names().step(step) + " (Escape ends this)");
    return goes_on && !interrupt.requested();
  };
  if (session.scale) debugger.set_content_scale(*session.scale);
  WindowKeeper keeper(debugger, session.window_file, session.theme);
  WindowLoop loop(window, debugger, session.scale);
  if (!lines.empty()) {
    ScriptPlayer(debugger, session.size.width, session.size.height, session.pictures, [&] {
      loop.present();
    }).play(lines);
    return keeper.keep();
  }
  debugger.welcome();
  if (session.is_tour) debugger.begin_tour();
  while (!window.should_close() && !interrupt.requested()) {
    if (!loop.turn()) continue;
    if (debugger.takes_screenshot()) save_picture(debugger, session.pictures);
    keeper.keep();
  }
}

}  // namespace

DebugCommand::DebugCommand(CLI::App& program)
    : command_(program.add_subcommand("debug", "Step through a run, forwards and backwards, and ask why")) {
  const auto option = [this](const char* name, std::string& text, const char* meaning, const char* type) {
    return command_->add_option(name, text, meaning)->type_name(type);
  };
  option("SCENE|FILE", texts_.scene, "A scene of `kerf scenes`, or a recording (default: a tour of one)", "");
  option("--steps", texts_.steps, "Of a scene: how many are recorded (default 300)", "N");
  option("--objects", texts_.objects, "Of a scene: moving objects (default: the scene's own)", "N");
  option("--grow", texts_.grow, "Of a scene: steps until all objects are there", "STEPS");
  option("--broad-phase", texts_.broad_phase, "Of a scene: kerf-paper (default) or kerf, the tuned tree",
         "NAME");
  option("--config", texts_.config, "Of a scene: parameters of the tree, see `kerf render --help`",
         "K=V,...");
  option("--seed", texts_.seed, "Of a scene: of every random choice (default 1)", "S");
  add_output(*command_, "--record", texts_.record, "Of a scene: keep the recording under this name");
  command_->add_flag("--overwrite", texts_.overwrite, "Replace an earlier recording and earlier pictures");
  option("--size", texts_.size, "Of the window or the pictures (default 1280x720)", "WxH");
  option("--scale", scale_, "Pixels for each that panels count in (default: what the display asks for)", "X");
  option("--theme", theme_, "light or dark (default: the last one, at first light)", "NAME");
  option("--window-file", window_file_,
         "Where layout, size of texts and theme are remembered, or none (default:\n"
         "kerf/debug-window in $XDG_CONFIG_HOME or ~/.config; with --script: none)",
         "FILE");
  command_->add_flag("--headless", headless_, "Without a window or display: needs --script");
  option("--script", script_, "Do what this file says, and end", "FILE");
  add_output(*command_, "-o,--out", out_, "Folder for the pictures of F12 and of scripts (default: here)",
             "DIR");
  command_->footer(kDebugFooter);
}

bool DebugCommand::is_tour() const { return texts_.scene.empty(); }

bool DebugCommand::chosen() const { return command_->parsed(); }

std::filesystem::path DebugCommand::recording(const std::filesystem::path& scratch) const {
  if (!is_tour() && names_recording(texts_)) {
    refuse_scene_options(texts_);
    refuse_of_recording(texts_, "--steps", texts_.steps);
    return texts_.scene;
  }
  RenderTexts texts = texts_;
  if (is_tour()) {
    texts.scene = kSceneOfTour;
    const auto unless_given = [](std::string& text, const char* value) {
      if (text.empty()) text = value;
    };
    unless_given(texts.objects, "300");
    unless_given(texts.grow, "80");
    unless_given(texts.steps, "150");
  }
  const bool is_kept = !texts.record.empty();
  if (texts.steps.empty()) texts.steps = "300";
  if (!is_kept) texts.record = scratch / "run.kerf";
  try {
    record_scene(parse_request(texts), is_kept ? CostOfRecording::printed : CostOfRecording::silent);
  } catch (const Interrupted&) {
    if (is_kept) throw;
    throw Interrupted("interrupted while recording " + texts.scene +
                      "; what there was of it is gone: keep it by --record FILE, or ask for fewer --steps");
  }
  return texts.record;
}

std::optional<double> DebugCommand::scale() const {
  if (scale_.empty()) return script_.empty() ? std::nullopt : std::optional(1.0);
  const auto scale = parse_number<double>(scale_);
  if (!scale || !(*scale >= 0.5 && *scale <= 8))
    throw UsageError("--scale " + scale_ +
                     ": it is a number from 0.5 to 8, for example 2 for a fine display");
  return scale;
}

std::optional<ThemeName> DebugCommand::theme() const {
  if (theme_.empty()) return std::nullopt;
  const auto found = std::ranges::find(kThemeNames, theme_);
  if (found == kThemeNames.end()) throw UsageError("--theme " + theme_ + ": it is light or dark");
  return static_cast<ThemeName>(found - kThemeNames.begin());
}

std::optional<std::filesystem::path> DebugCommand::window_file() const {
  if (window_file_ == "none") return std::nullopt;
  if (!window_file_.empty()) return window_file_;
  return script_.empty() ? usual_window_file() : std::nullopt;
}

void DebugCommand::run() const {
  if (headless_ && script_.empty())
    throw UsageError("--headless needs a --script to drive it; leave it out for a window");
  std::vector<ScriptLine> lines;
  try {
    if (!script_.empty()) lines = parse_script(read_script(script_));
  } catch (const ScriptError& error) {
    throw UsageError(script_ + ", " + error.what());
  }
  const PictureSize size = texts_.size.empty() ? PictureSize{1280, 720} : parse_picture_size(texts_.size);
  if (size.width < kLeastDebuggerWidth || size.height < kLeastDebuggerHeight)
    throw UsageError("--size " + texts_.size + ": the panels need at least " +
                     std::to_string(kLeastDebuggerWidth) + "x" + std::to_string(kLeastDebuggerHeight));
  const auto pixels = scale();
  const auto colours = theme();
  Outputs outputs({script_, !is_tour() && names_recording(texts_) ? texts_.scene : ""}, texts_.overwrite);
  const PictureFolder pictures{out_.empty() ? "." : out_, outputs.replace()};
  outputs.add_recording(texts_.record);
  add_pictures(lines, pictures.path, outputs);
  if (!out_.empty()) make_writable_folder(out_);
  const ScratchFolder scratch;
  const std::filesystem::path file = recording(scratch.path());
  tune_allocator_for_rendering();
  const Session session{.file = file,
                        .name = is_tour() ? kSceneOfTour : texts_.scene,
                        .is_tour = is_tour(),
                        .work_folder = scratch.path(),
                        .pictures = pictures,
                        .size = size,
                        .grows = texts_.size.empty() && scale_.empty() && script_.empty(),
                        .scale = pixels,
                        .theme = colours,
                        .window_file = window_file()};
  try {
    if (headless_) {
      play_headless(session, lines);
    } else {
      show_window(session, lines);
    }
  } catch (const ExpectationFailed& error) {
    throw DoesNotHold(script_ + ", " + error.what());
  } catch (const ScriptError& error) {
    throw std::runtime_error(script_ + ", " + error.what());
  }
}

}  // namespace kerf
