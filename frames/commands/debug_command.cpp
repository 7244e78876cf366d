#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "frames/commands/command.h"
#include "frames/commands/record_in_window.h"
#include "frames/commands/window_keeper.h"
#include "frames/sequence/render_request.h"
#include "frames/support/atomic_file.h"
#include "frames/support/errors.h"
#include "frames/support/interrupt.h"
#include "frames/support/outputs.h"
#include "frames/support/parse_number.h"
#include "frames/support/scratch_folder.h"
#include "frames/support/text_file.h"
#include "viz/debugger/debugger.h"
#include "viz/debugger/gui/glfw_window.h"
#include "viz/debugger/script.h"
#include "viz/debugger/session/recent_files.h"
#include "viz/debugger/window_loop.h"
#include "viz/draw/theme.h"
#include "viz/gl/context.h"
#include "viz/image/png.h"

namespace kerf {
namespace {

constexpr const char* kSceneOfTour = "pile";

constexpr const char* kDebugFooter =
    "SCENE is recorded first, into a temporary file; FILE is what `kerf record` or `kerf import` wrote.\n"
    "In the window, F1 shows the keys. docs/DEBUGGING.md is a guide, and has the commands of scripts.";

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
struct Sitting {
  std::filesystem::path file;
  std::string name;      ///< as the user named it
  bool is_tour = false;  ///< of a scene of our own, since none was named
  std::filesystem::path work_folder;
  std::vector<std::filesystem::path> sessions;  ///< named by the user
  PictureFolder pictures;
  PictureSize size;
  std::optional<double> scale{};  ///< pixels in a unit of the panels, if given
  std::optional<ThemeName> theme{};
  std::optional<std::filesystem::path> window_file{};  ///< layout, zoom and theme from start to start
};

void print_line(const std::string& text) { std::fprintf(stderr, "%s\n", text.c_str()); }

void play_headless(const Sitting& sitting, const std::vector<ScriptLine>& lines) {
  const InterruptGuard interrupt;
  const auto check = [&] {
    if (interrupt.requested()) throw Interrupted("interrupted while the script was played");
  };
  const auto context = make_offscreen_context();
  Debugger debugger(*context, open_run(sitting.file));
  debugger.model().work_folder = sitting.work_folder;
  debugger.model().on_long_work = [&](std::uint32_t /*step*/) { return !interrupt.requested(); };
  debugger.on_earlier_session(print_line);
  if (sitting.scale) debugger.set_content_scale(*sitting.scale);
  WindowKeeper keeper(debugger, sitting.window_file, sitting.theme);
  debugger.go_on_with_files(sitting.sessions);
  ScriptPlayer(debugger, sitting.size.width, sitting.size.height, sitting.pictures, check).play(lines);
  keeper.keep();
  if (const std::string problem = debugger.keep_session(); !problem.empty())
    throw std::runtime_error(problem);
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

/// The window closes: what is to be said goes to the terminal.
void leave(Debugger& debugger) {
  const std::string problem = debugger.keep_session();
  if (!problem.empty()) print_line(problem);
}

void show_window(const Sitting& sitting, const std::vector<ScriptLine>& lines, GlfwWindow& window) {
  const InterruptGuard interrupt;
  show_opening(sitting.name, window);
  std::unique_ptr<Run> run = open_run(sitting.file);
  Debugger debugger(window, std::move(run));
  debugger.model().work_folder = sitting.work_folder;
  debugger.on_earlier_session(print_line);
  window.set_title(debugger.title());
  debugger.go_on_with_files(sitting.sessions);
  debugger.model().on_long_work = [&](std::uint32_t step) {
    const bool goes_on =
        window.goes_on("step " + debugger.model().run().names().step(step) + " (Escape ends this)");
    return goes_on && !interrupt.requested();
  };
  if (sitting.scale) debugger.set_content_scale(*sitting.scale);
  WindowKeeper keeper(debugger, sitting.window_file, sitting.theme);
  WindowLoop loop(window, debugger, sitting.scale);
  if (!lines.empty()) {
    ScriptPlayer(debugger, sitting.size.width, sitting.size.height, sitting.pictures, [&] {
      loop.present();
    }).play(lines);
    keeper.keep();
    leave(debugger);
    return;
  }
  if (sitting.sessions.empty()) debugger.welcome();
  if (sitting.is_tour) debugger.begin_tour();
  debugger.remember_in(config_folder());
  debugger.keep_sessions_beside();
  while (!window.should_close() && !interrupt.requested()) {
    if (loop.turn()) {
      if (debugger.takes_screenshot()) save_picture(debugger, sitting.pictures);
      keeper.keep();
    }
    window.set_title(debugger.title());
    debugger.keep_session_at(window.seconds());
  }
  leave(debugger);
}

class DebugCommand final : public Command {
 public:
  explicit DebugCommand(CLI::App& program);
  void run() const override;

 private:
  /// No scene is named: a tour of one of ours begins.
  [[nodiscard]] bool is_tour() const;
  /// As the user named it.
  [[nodiscard]] std::string name() const;
  /// What is to be recorded, below `scratch` unless it is to be kept; nothing if a recording was given.
  [[nodiscard]] std::optional<RenderRequest> scene(const std::filesystem::path& scratch) const;
  /// Records it; the window, if there is one, shows how far that is.
  [[nodiscard]] std::filesystem::path record(const RenderRequest& request, GlfwWindow* window) const;

  [[nodiscard]] std::optional<double> scale() const;
  [[nodiscard]] std::optional<ThemeName> theme() const;
  [[nodiscard]] std::optional<std::filesystem::path> window_file() const;

  RenderTexts texts_;
  std::string script_;
  std::string out_;
  std::string scale_;
  std::string theme_;
  std::string window_file_;
  std::vector<std::string> sessions_;
  bool headless_ = false;
};

DebugCommand::DebugCommand(CLI::App& program)
    : Command(program, "debug", "Step through a run, forwards and backwards, and ask why") {
  option("SCENE|FILE", texts_.scene, "A scene of `kerf scenes`, or a recording (default: a tour of one)", "");
  option("--steps", texts_.steps, "Of a scene: how many are recorded (default 300)", "N");
  option("--objects", texts_.objects, "Of a scene: moving objects (default: the scene's own)", "N");
  option("--grow", texts_.grow, "Of a scene: steps until all objects are there", "STEPS");
  option("--broad-phase", texts_.broad_phase, "Of a scene: kerf-paper (default) or kerf, the tuned tree",
         "NAME");
  option("--config", texts_.config, "Of a scene: parameters of the tree, see `kerf render --help`",
         "K=V,...");
  option("--seed", texts_.seed, "Of a scene: of every random choice (default 1)", "S");
  output("--record", texts_.record, "Of a scene: keep the recording under this name");
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
  option("--session", sessions_,
         "Go on where it was, and keep it there (default in a window: FILE.session); several are joined",
         "FILE")
      ->allow_extra_args(false);
  output("-o,--out", out_, "Folder for the pictures of F12 and of scripts (default: here)", "DIR");
  command_->footer(kDebugFooter);
}

bool DebugCommand::is_tour() const { return texts_.scene.empty(); }

std::string DebugCommand::name() const { return is_tour() ? kSceneOfTour : texts_.scene; }

std::optional<RenderRequest> DebugCommand::scene(const std::filesystem::path& scratch) const {
  if (!is_tour() && names_recording(texts_)) {
    refuse_scene_options(texts_);
    refuse_of_recording(texts_, "--steps", texts_.steps);
    return {};
  }
  RenderTexts texts = texts_;
  const auto unless_given = [](std::string& text, const std::string& value) {
    if (text.empty()) text = value;
  };
  if (is_tour()) {
    texts.scene = name();
    unless_given(texts.objects, "300");
    unless_given(texts.grow, "80");
    unless_given(texts.steps, "150");
  }
  check_recorded_steps(texts.steps);
  unless_given(texts.steps, "300");
  unless_given(texts.record, scratch / "run.kerf");
  return parse_request(texts);
}

std::filesystem::path DebugCommand::record(const RenderRequest& request, GlfwWindow* window) const {
  const bool is_kept = !texts_.record.empty();
  const auto cost = is_kept ? CostOfRecording::printed : CostOfRecording::silent;
  try {
    return window == nullptr ? record_scene(request, cost) : record_in_window(request, cost, *window);
  } catch (const Interrupted&) {
    if (is_kept) throw;
    throw Interrupted("interrupted while recording " + name() +
                      "; what there was of it is gone: keep it by --record FILE, or ask for fewer --steps");
  }
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
  const std::filesystem::path folder = config_folder();
  if (!script_.empty() || folder.empty()) return std::nullopt;
  return folder / "debug-window";
}

void DebugCommand::run() const {
  if (headless_ && script_.empty())
    throw UsageError("--headless needs a --script to drive it; leave it out for a window");
  std::vector<ScriptLine> lines;
  try {
    if (!script_.empty()) lines = parse_script(read_text_file(script_));
  } catch (const ScriptError& error) {
    throw UsageError(script_ + ", " + error.what());
  }
  const PictureSize size = texts_.size.empty() ? PictureSize{1280, 720} : parse_picture_size(texts_.size);
  if (size.width < kLeastDebuggerWidth || size.height < kLeastDebuggerHeight)
    throw UsageError("--size " + texts_.size + ": the panels need at least " +
                     std::to_string(kLeastDebuggerWidth) + "x" + std::to_string(kLeastDebuggerHeight));
  const auto pixels = scale();
  const auto colours = theme();
  std::vector<std::filesystem::path> inputs{script_,
                                            !is_tour() && names_recording(texts_) ? texts_.scene : ""};
  inputs.insert(inputs.end(), sessions_.begin(), sessions_.end());
  Outputs outputs(std::move(inputs), texts_.overwrite);
  const PictureFolder pictures{out_.empty() ? "." : out_, outputs.replace()};
  outputs.add_recording(texts_.record);
  add_pictures(lines, pictures.path, outputs);
  const auto remembered = window_file();
  if (remembered && !window_file_.empty()) {  // of one that was not named the window says what is wrong
    outputs.add_kept(*remembered);
    check_window_file(*remembered);
  }
  if (!out_.empty()) make_writable_folder(out_);
  const InterruptGuard interrupt;  // before there is a folder that an interrupt would leave
  const ScratchFolder scratch;
  const std::optional<RenderRequest> request = scene(scratch.path());
  std::optional<GlfwWindow> window;
  const bool grows = texts_.size.empty() && scale_.empty() && script_.empty();  // with the display
  if (!headless_) window.emplace(name() + " - kerf debug", size.width, size.height, grows);
  const std::filesystem::path file =
      request ? record(*request, window ? &*window : nullptr) : std::filesystem::path(texts_.scene);
  tune_allocator_for_rendering();
  const Sitting sitting{.file = file,
                        .name = name(),
                        .is_tour = is_tour(),
                        .work_folder = scratch.path(),
                        .sessions = {sessions_.begin(), sessions_.end()},
                        .pictures = pictures,
                        .size = size,
                        .scale = pixels,
                        .theme = colours,
                        .window_file = remembered};
  try {
    if (headless_) {
      play_headless(sitting, lines);
    } else {
      show_window(sitting, lines, *window);
    }
  } catch (const ExpectationFailed& error) {
    throw DoesNotHold(script_ + ", " + error.what());
  } catch (const ScriptError& error) {
    throw std::runtime_error(script_ + ", " + error.what());
  }
}

}  // namespace

AnyCommand make_debug_command(CLI::App& program) { return std::make_unique<DebugCommand>(program); }

}  // namespace kerf
