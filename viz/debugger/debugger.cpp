#include "viz/debugger/debugger.h"

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "viz/debugger/gui/widgets.h"
#include "viz/draw/palette.h"

namespace kerf {
namespace {

constexpr auto kFixedWindow = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                              ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                              ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

constexpr double kLongestPause = 0.25;  // seconds by which a run that plays can be late and catches up
constexpr float kLeastLane = 15;        // the height of a lane with a line of text
constexpr float kTabs = 418;            // the width of all tabs side by side
constexpr float kToolsInTwoRows =
    580;                              // the width of the view's tools in two rows; below it they take three,
constexpr float kToolsInThree = 380;  // and below this one four

/// A window that fills an area exactly, which is named for the tour and for scripts.
template <class Draw>
void in_window(Gui& gui, const char* name, const PanelArea& area, Draw draw, int flags = 0) {
  gui.name_area(std::string("panel ") + name, area);
  ImGui::SetNextWindowPos({area.x, area.y});
  ImGui::SetNextWindowSize({area.width, area.height});
  if (ImGui::Begin(name, nullptr, kFixedWindow | flags)) draw();
  ImGui::End();
}

void draw_tab(PanelContext& context, const char* name, void (*draw)(PanelContext&)) {
  const bool wanted = context.memory.open_tab == name;
  const bool open = ImGui::BeginTabItem(name, nullptr, wanted ? ImGuiTabItemFlags_SetSelected : 0);
  context.gui.name_last_item(std::string("tab ") + name, name);
  if (!open) return;
  context.memory.session.shown_tab = name;
  ImGui::BeginChild(name, {0, 0}, false);
  draw(context);
  ImGui::EndChild();
  ImGui::EndTabItem();
}

void draw_tabs(PanelContext& context) {
  const ImVec2 usual = ImGui::GetStyle().ItemInnerSpacing;
  ImGui::GetStyle().ItemInnerSpacing = {2, usual.y};
  if (ImGui::BeginTabBar("tabs", ImGuiTabBarFlags_FittingPolicyScroll)) {
    draw_tab(context, "Why", draw_why);
    draw_tab(context, "Ballot", draw_ballot);
    draw_tab(context, "Algorithm", draw_algorithm);
    draw_tab(context, "Oracle", draw_oracle);
    draw_tab(context, "What if", draw_what_if);
    draw_tab(context, "Compare", draw_compare);
    draw_tab(context, "Lint", draw_lint);
    draw_tab(context, "Tables", draw_tables);
    ImGui::EndTabBar();
  }
  ImGui::GetStyle().ItemInnerSpacing = usual;
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
  ImGui::BeginTooltip();
  ImGui::TextUnformatted(context.memory.under_mouse.c_str());
  context.gui.note_last_item("under the mouse");
  ImGui::EndTooltip();
}

}  // namespace

PanelLayout layout_panels(int width, int height, std::size_t lanes) {
  const auto w = static_cast<float>(width);
  const auto h = static_cast<float>(height);
  const float left = std::floor(std::clamp(0.19F * w, 210.0F, 330.0F));
  const float right = std::floor(std::clamp(0.335F * w, kTabs, 560.0F));
  const float least = 212.0F + kLeastLane * static_cast<float>(std::max(lanes, kLanesOfRun) - kLanesOfRun);
  const float below = std::floor(std::clamp(0.28F * h, least, 300.0F));
  constexpr float kTop = 58;
  const float room = w - left - right;
  const float tools = room < kToolsInThree ? 106 : room < kToolsInTwoRows ? 82 : 58;
  const float middle = h - kTop - below;
  const float outline = std::floor(0.4F * middle);
  const float icicle = std::floor(0.24F * middle);
  const float half_right = std::floor(0.36F * middle);
  PanelLayout layout;
  layout.transport = {0, 0, w, kTop};
  layout.left_above = {0, kTop, left, outline};
  layout.left_middle = {0, kTop + outline, left, icicle};
  layout.left_below = {0, kTop + outline + icicle, left, middle - outline - icicle};
  layout.right_above = {w - right, kTop, right, half_right};
  layout.right_below = {w - right, kTop + half_right, right, middle - half_right};
  layout.tools = {left, kTop, w - left - right, tools};
  layout.view = {left, kTop + tools, w - left - right, middle - tools};
  layout.timeline = {0, h - below, w, below};
  return layout;
}

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
  if (width != width_ || height != height_) framebuffer_.emplace(context_.functions(), width, height, 1);
  width_ = width;
  height_ = height;
  layout_ = layout_panels(width, height, model_.lanes().size());
  const PanelLayout& layout = layout_;
  // After long work it does not make up for all of the time.
  model_.pass_time(std::min(input.seconds, kLongestPause + model_.seconds_to_next()));
  gui_.begin(input, width, height);
  if (input.key && !gui_.is_typing() && !take_session_key(input)) take_key(*input.key, input.shift);
  update_views(layout);
  const auto start = std::chrono::steady_clock::now();
  PanelContext context{model_, gui_, memory_, *view_};
  draw_panels(context, layout);
  gui_.end();
  see_view(input);
  panel_seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void Debugger::draw() {
  const PanelLayout& layout = layout_;
  framebuffer_->bind();
  const auto& gl = context_.functions();
  gl.ClearColor(0.93F, 0.93F, 0.91F, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  const int x = static_cast<int>(layout.view.x);
  view_->copy_to(*framebuffer_, x, static_cast<int>(layout.view.y));
  if (other_view_)
    other_view_->copy_to(*framebuffer_, x + static_cast<int>(layout.view.width) / 2,
                         static_cast<int>(layout.view.y));
  framebuffer_->bind();
  gui_.draw();
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
void Debugger::update_views(const PanelLayout& layout) {
  Run* const other = model_.other();
  if (&model_.run() != run_) view_ = make_scene_view(context_.functions(), model_.run());
  run_ = &model_.run();
  if (other != other_) {
    other_view_ = other == nullptr ? nullptr : make_scene_view(context_.functions(), *other);
    other_ = other;
  }
  const int width = static_cast<int>(layout.view.width) / (other == nullptr ? 1 : 2);
  const int height = static_cast<int>(layout.view.height);
  const Tint tint = model_.view.tint;
  double tint_end = view_->tints(tint).end;
  if (other_view_) tint_end = std::max(tint_end, other_view_->tints(tint).end);
  view_->update(model_, width, height, tint_end);
  if (!other_view_) return;
  other_view_->look_like(*view_);
  other_view_->update(model_, width, height, tint_end);
}

void Debugger::draw_panels(PanelContext& context, const PanelLayout& layout) {
  const std::string wanted_tab = memory_.open_tab;
  memory_.under_mouse = "nothing";
  in_window(gui_, "transport", layout.transport, [&] { draw_transport(context); });
  in_window(gui_, "tree", layout.left_above, [&] { draw_outline(context); });
  in_window(
      gui_, "icicle", layout.left_middle, [&] { draw_icicle(context); },
      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  in_window(gui_, "breakpoints", layout.left_below, [&] { draw_breakpoints(context); });
  in_window(gui_, "events", layout.right_above, [&] { draw_events(context); });
  in_window(gui_, "inspector", layout.right_below, [&] {
    const ImVec2 usual = ImGui::GetStyle().FramePadding;
    ImGui::GetStyle().FramePadding = {3, usual.y};  // all tabs side by side
    draw_tabs(context);
    ImGui::GetStyle().FramePadding = usual;
  });
  if (memory_.open_tab == wanted_tab) memory_.open_tab.clear();
  in_window(gui_, "tools", layout.tools, [&] { draw_view_tools(context); });
  draw_view(context, layout);
  in_window(
      gui_, "timeline", layout.timeline, [&] { draw_timeline(context); },
      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  draw_welcome(context);
  draw_session_offer(context);
  draw_tour(context);
  draw_search(context);
  draw_help(context);
  copy_as_wished(context);
  model_.hovered_node = std::exchange(memory_.hovered_node, std::nullopt);
}

void Debugger::draw_view(PanelContext& context, const PanelLayout& layout) {
  const PanelArea& area = layout.view;
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
  const ImVec2 moved = io.MouseDelta;
  if (ImGui::IsItemActive() && (moved.x != 0 || moved.y != 0)) {
    if (io.MouseDown[1]) {
      view_->move(double{moved.x}, double{moved.y});
    } else {
      view_->turn(double{moved.x}, double{moved.y});
    }
  }
  const double x = double{io.MousePos.x - area.x};
  const double y = double{io.MousePos.y - area.y};
  if (hovered && io.MouseWheel != 0) view_->zoom(double{io.MouseWheel}, x, y);
  if (hovered) point_at(context, x, y);
}

/// Beside a compared run, at the right, lies the other run's view.
void Debugger::point_at(PanelContext& context, double x, double y) {
  const ImGuiIO& io = ImGui::GetIO();
  const double half = double{layout_.view.width} / 2;
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
  constexpr float kStill = 4;
  const bool clicked = ImGui::IsMouseReleased(0) && io.MouseClickedLastCount[0] == 1 &&
                       io.MouseDragMaxDistanceSqr[0] < kStill * kStill;
  if (!clicked || is_theirs) return;
  if (const auto object = object_in(thing)) {
    context.model.select_object(*object, io.KeyShift);
  } else {
    context.model.select(thing);
  }
}

}  // namespace kerf
