#include "viz/debugger/debugger.h"

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "viz/debugger/panels/cells.h"
#include "viz/debugger/panels/panel_window.h"

namespace kerf {
namespace {

constexpr double kLongestPause = 0.25;  // seconds by which a run that plays can be late and catches up
constexpr double kLeastScale = 0.5;

/// Whether the mouse has left its place since the button went down: it does not click.
bool has_dragged(int button) {
  constexpr float kStill = 4;  // pixels
  return ImGui::GetIO().MouseDragMaxDistanceSqr[button] >= kStill * kStill;
}

/// What is under the mouse: an object, else a pair, else a node.
Selection thing_at(const SceneView& view, double x, double y, bool node_wanted) {
  const Selection thing = view.pick(x, y, node_wanted);
  if (node_wanted || object_in(thing)) return thing;
  const auto pair = view.pick_pair(x, y);
  return pair ? Selection(*pair) : thing;
}

void say_what_is_under_mouse(PanelContext& context, const Selection& thing, Run& run) {
  if (is_nothing(thing)) return;
  context.memory.under_mouse = thing_words(run, thing);
  constexpr float kAround = 6;  // the scene's window has none
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {kAround, kAround});
  ImGui::BeginTooltip();
  ImGui::TextUnformatted(context.memory.under_mouse.c_str());
  context.gui.note_last_item("under the mouse");
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

}  // namespace

Debugger::Debugger(GlContext& context, std::unique_ptr<Run> run)
    : context_(context),
      model_(std::move(run)),
      gui_(context.functions()),
      view_(make_scene_view(context.functions(), model_.run())),
      run_(&model_.run()),
      recording_(run_->path()) {}

void Debugger::frame(const DebuggerInput& input, int width, int height) {
  take_in(input, width, height);
  draw();
}

void Debugger::take_in(const DebuggerInput& input, int width, int height) {
  context_.make_current();
  do_what_was_asked(input);
  width = std::max(width, kLeastDebuggerWidth);
  height = std::max(height, kLeastDebuggerHeight);
  if (width != width_ || height != height_) {
    framebuffer_.emplace(context_.functions(), width, height, 1);
    forget_picture();
  }
  width_ = width;
  height_ = height;
  arrange_window();
  // After long work it does not make up for all of the time.
  model_.pass_time(std::min(input.seconds, kLongestPause + model_.seconds_to_next()));
  gui_.begin(input, width, height);
  if (input.key) take_any_key(input);
  update_views();
  const auto start = std::chrono::steady_clock::now();
  PanelContext context{model_, gui_, memory_, *view_};
  draw_panels(context);
  gui_.end();
  see_view(input);
  panel_seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (const auto name = std::exchange(memory_.press, std::nullopt)) press(*name);
}

/// Keys with Ctrl work in menus, too; nothing but text goes into a text field.
void Debugger::take_any_key(const DebuggerInput& input) {
  if (input.control && take_control_key(*input.key, input.shift)) return;
  if (!gui_.has_keys() && !take_session_key(input)) take_key(*input.key, input.shift);
}

/// A place of the panels in whole pixels.
float Debugger::pixels(float units) const { return std::floor(units * static_cast<float>(gui_.scale())); }

PixelArea Debugger::in_pixels(const PanelArea& area) const {
  const auto x = static_cast<int>(pixels(area.x));
  const auto y = static_cast<int>(pixels(area.y));
  return {x, y, static_cast<int>(pixels(area.right())) - x, static_cast<int>(pixels(area.bottom())) - y};
}

void Debugger::arrange_window() {
  const WindowSettings& window = memory_.window;
  const std::size_t lanes = std::max(model_.lanes().size(), kLanesOfRun) - kLanesOfRun;
  const WindowSize least = least_window(window.layout, lanes);
  const double most = std::min(width_ / double{least.width}, height_ / double{least.height});
  constexpr double kSteps = 20;  // of a unit: the typeface is not made anew for each pixel of a window
  const double wanted = content_scale_ * window.zoom;
  gui_.set_scale(wanted <= most ? wanted : std::max(kLeastScale, std::floor(most * kSteps) / kSteps));
  gui_.set_theme(theme_called(window.theme));
  const auto units = [&](int count) { return static_cast<float>(std::ceil(count / gui_.scale())); };
  arrangement_ =
      arrange(window.layout, {units(width_), units(height_), lanes, model_.run().has_their_structure()});
  const PanelArea& view = arrangement_.view;
  const WindowSize& size = arrangement_.size;
  memory_.extents = {view.x / size.width, 1 - view.right() / size.width, 1 - view.bottom() / size.height};
}

/// All, or only the scene if nothing beside it has changed. At scales with a fraction the pixels along its
/// border belong to both.
PixelArea Debugger::part_to_draw() {
  const bool is_same = gui_.is_same_beside(arrangement_.view);
  if (std::exchange(is_new_, false) || !is_same) {
    ++panel_pictures_;
    return {0, 0, width_, height_};
  }
  const auto [x, y, width, height] = in_pixels(arrangement_.view);
  return {x - 1, y - 1, width + 2, height + 2};
}

void Debugger::draw() {
  const PixelArea part = part_to_draw();
  const PixelArea scene = in_pixels(arrangement_.view);
  framebuffer_->bind();
  const auto& gl = context_.functions();
  const Color ground = theme_called(memory_.window.theme).panel;
  gl.ClearColor(static_cast<float>(ground.r) / 255, static_cast<float>(ground.g) / 255,
                static_cast<float>(ground.b) / 255, 1);
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(part.x, part.y, part.width, part.height);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  view_->copy_to(*framebuffer_, scene.x, scene.y);
  if (other_view_)
    other_view_->copy_to(
        *framebuffer_, static_cast<int>(pixels(arrangement_.view.x + arrangement_.view.width / 2)), scene.y);
  framebuffer_->bind();
  gui_.draw_within(part);
  check_gl(gl, "drawing the debugger");
}

const Image& Debugger::picture() {
  context_.make_current();
  framebuffer_->read(image_);
  return image_;
}

void Debugger::welcome() {
  model_.go_to_opening();
  memory_.welcome = true;
}

bool Debugger::takes_screenshot() { return std::exchange(memory_.screenshot, false); }

std::optional<std::string> Debugger::take_copied() {
  return std::exchange(memory_.to_clipboard, std::nullopt);
}

void Debugger::report(std::string message, bool is_error) {
  model_.message = std::move(message);
  model_.message_is_error = is_error;
}

/// The compared run is seen beside this one, from the same place and in the same colours.
void Debugger::update_views() {
  Run* const other = model_.other();
  if (&model_.run() != run_) {
    const AnyCamera camera = view_->camera();
    view_ = make_scene_view(context_.functions(), model_.run());
    view_->set_camera(camera);
  }
  run_ = &model_.run();
  if (other != other_) {
    other_view_ = other == nullptr ? nullptr : make_scene_view(context_.functions(), *other);
    other_ = other;
  }
  const auto [x, y, all, height] = in_pixels(arrangement_.view);
  const int width = other == nullptr ? all : all / 2;
  const SceneLook look{gui_.scale(), &theme_called(memory_.window.theme), is_turning_,
                       gui_.scale() * overlay_above(), gui_.scale() * overlay_below()};
  view_->look = look;
  if (other_view_) other_view_->look = look;
  const Tint tint = model_.view.tint;
  double tint_end = view_->tints(tint).end;
  if (other_view_) tint_end = std::max(tint_end, other_view_->tints(tint).end);
  view_->update(model_, width, height, tint_end);
  if (!other_view_) return;
  other_view_->look_like(*view_);
  other_view_->update(model_, width, height, tint_end);
}

void Debugger::draw_panels(PanelContext& context) {
  if (const auto wanted = panel_titled(memory_.open_tab)) memory_.window.layout.show(*wanted);
  memory_.open_tab.clear();
  memory_.under_mouse = "nothing";
  in_window(gui_, "transport", arrangement_.transport, [&] { draw_transport(context); });
  draw_cells(context, arrangement_);
  in_window(gui_, "tools", arrangement_.tools, [&] { draw_view_tools(context); });
  draw_view(context);
  draw_dividers(context, arrangement_);
  drag_panel(context, arrangement_);
  draw_welcome(context);
  draw_session_offer(context);
  draw_tour(context);
  draw_search(context);
  draw_help(context);
  copy_as_wished(context);
  model_.hovered_node = std::exchange(memory_.hovered_node, std::nullopt);
}

void Debugger::draw_view(PanelContext& context) {
  const PanelArea& area = arrangement_.view;
  gui_.name_area("view", area);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  in_window(
      gui_, "view", area,
      [&] {
        use_mouse(context, area);
        PanelArea part = area;
        if (other_view_) part.width *= 0.5F;
        const std::string name = model_.run().info().scene;
        draw_view_overlay(
            context, *view_, part,
            other_view_ ? "this run, " + to_string(model_.run().position(), model_.run().names()) : name);
        if (!other_view_ || model_.other() == nullptr) return;  // it may have ended in this frame
        part.x += part.width;
        draw_view_overlay(context, *other_view_, part,
                          "the other run, " + to_string(model_.other()->position(), model_.other()->names()));
      },
      ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
}

void Debugger::use_mouse(PanelContext& context, const PanelArea& area) {
  ImGui::InvisibleButton("scene", {area.width, area.height},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  const ImGuiIO& io = ImGui::GetIO();
  const bool hovered = ImGui::IsItemHovered();
  const auto scale = static_cast<float>(gui_.scale());
  const int button = io.MouseDown[1] ? 1 : 0;
  const bool was_turning = std::exchange(is_turning_, ImGui::IsItemActive() && has_dragged(button));
  if (is_turning_) {  // what a hand trembles in a click moves nothing; the whole way counts once it is a drag
    const ImVec2 way = was_turning ? io.MouseDelta : ImGui::GetMouseDragDelta(button, 0);
    const double right = double{scale * way.x};
    const double down = double{scale * way.y};
    if (right != 0 || down != 0) button == 1 ? view_->move(right, down) : view_->turn(right, down);
  }
  const double x = double{scale * io.MousePos.x - pixels(area.x)};
  const double y = double{scale * io.MousePos.y - pixels(area.y)};
  over_scene_ = hovered ? std::optional(Eigen::Vector2d(x, y)) : std::nullopt;
  if (hovered && io.MouseWheel != 0) view_->zoom(double{io.MouseWheel}, x, y);
  if (hovered) point_at(context, x, y);
}

/// Beside a compared run, at the right, lies the other run's view.
void Debugger::point_at(PanelContext& context, double x, double y) {
  const ImGuiIO& io = ImGui::GetIO();
  const PanelArea& view = arrangement_.view;
  const double half = double{pixels(view.x + view.width / 2) - pixels(view.x)};
  const bool is_other = other_view_ && x >= half;
  if (is_other && model_.other() == nullptr) return;  // it has ended in this frame
  const Selection thing =
      is_other ? thing_at(*other_view_, x - half, y, io.KeyCtrl) : thing_at(*view_, x, y, io.KeyCtrl);
  // Objects are the same in both runs, nodes are not.
  const bool is_theirs = is_other && node_in(thing);
  if (!io.MouseDown[0] && !io.MouseDown[1]) {
    say_what_is_under_mouse(context, thing, is_other ? *model_.other() : model_.run());
    if (const auto node = node_in(thing); node && !is_theirs) memory_.hovered_node = node;
  }
  // A click that did not turn the view; the second one of a double click says nothing new.
  const bool clicked = ImGui::IsMouseReleased(0) && io.MouseClickedLastCount[0] == 1 && !has_dragged(0);
  if (!clicked || is_theirs) return;
  if (const auto object = object_in(thing)) {
    context.model.select_object(*object, io.KeyShift);
  } else {
    context.model.select(thing);
  }
}

}  // namespace kerf
