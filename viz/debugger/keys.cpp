#include <utility>

#include "viz/debugger/debugger.h"
#include "viz/debugger/model/tree_walk.h"

namespace kerf {
namespace {

/// 1 is the first kind, 0 the tenth.
EventKind kind_of_digit(int digit) { return static_cast<EventKind>((digit + 9) % 10); }

EventKind neighbour(EventKind kind, bool next) {
  const std::size_t count = kEventKindNames.size();
  return static_cast<EventKind>((static_cast<std::size_t>(kind) + (next ? 1 : count - 1)) % count);
}

/// The keys of what lies over the panels. False if the key has no such meaning.
bool take_card_key(PanelMemory& memory, Key key) {
  switch (key) {
    case Key::p:
      open_search(memory.search);
      return true;
    case Key::f10:
      memory.window_menu_wanted = true;
      return true;
    case Key::g:
      memory.welcome = !memory.welcome;
      return true;
    case Key::f12:
      memory.screenshot = true;
      return true;
    case Key::f1:
    case Key::question:
      memory.help = !memory.help;
      return true;
    default:
      return false;
  }
}

}  // namespace

void Debugger::take_key(Key key, bool shift) {
  if (take_card_key(memory_, key)) return;
  switch (key) {
    case Key::space:
      model_.playing = !model_.playing;
      return;
    case Key::comma:
    case Key::period:
      return model_.step(shift ? Granularity::step : model_.granularity, key == Key::period);
    case Key::home:
    case Key::end:
      return model_.step(Granularity::run, key == Key::end);
    case Key::f:
      return view_->focus(model_.selection());
    case Key::v:
      return model_.view.face_next(!shift);
    case Key::h:
      return model_.toggle_hidden();
    case Key::i:
      return model_.toggle_isolated();
    case Key::b:
      return model_.toggle_bookmark();
    case Key::w:
      if (model_.go_to_error(!shift)) view_->focus(model_.selection());
      return;
    case Key::q:
      return ask_at_mouse();
    case Key::o:
      return static_cast<void>(model_.ask_oracle());
    case Key::escape:
      if (std::exchange(memory_.help, false)) return;
      if (std::exchange(memory_.tour, std::nullopt)) return;
      if (std::exchange(memory_.welcome, false)) return;
      model_.deselect();
      return model_.drop_range();
    case Key::f5:
      return model_.run_to_breakpoint(!shift);
    case Key::f9:
      return model_.toggle_breakpoint_here();
    case Key::enter:
      if (memory_.tour) ++*memory_.tour;
      return;
    case Key::a:
    case Key::u:
    case Key::d:
    case Key::x:
    case Key::t:
    case Key::j:
      return take_tree_key(key, shift);
    default:
      return take_time_key(key, shift);
  }
}

void Debugger::ask_at_mouse() {
  if (!over_scene_) return report("put the mouse over the scene: what lies behind it is asked for", false);
  model_.ask(view_->query_at(over_scene_->x(), over_scene_->y()));
}

/// The size of texts, and the camera. False if the key has no such meaning.
bool Debugger::take_control_key(Key key, bool shift) {
  constexpr double kPixels = 40;  // by which the camera moves
  const auto move_camera = [&](double x, double y) {
    if (shift) {
      view_->move(x * gui_.scale(), y * gui_.scale());
    } else {
      view_->turn(x * gui_.scale(), y * gui_.scale());
    }
    return true;
  };
  WindowSettings& window = memory_.window;
  switch (key) {
    case Key::plus:
    case Key::minus:
      window.zoom_by(key == Key::plus);
      return true;
    case Key::digit_0:
      window.zoom = 1;
      return true;
    case Key::period:
    case Key::comma: {
      const PanelArea& area = arrangement_.view;
      view_->zoom(key == Key::period ? 1 : -1, double{pixels(0.5F * area.width)},
                  double{pixels(0.5F * area.height)});
      return true;
    }
    case Key::left:
    case Key::right:
      return move_camera(key == Key::left ? -kPixels : kPixels, 0);
    case Key::up:
    case Key::down:
      return move_camera(0, key == Key::up ? -kPixels : kPixels);
    default:
      return false;
  }
}

/// As a click does: fields get the keys, lists open; what is dragged by the mouse becomes a field.
void Debugger::press(const std::string& name) {
  const auto place = gui_.find(name);
  if (!place) return;
  const auto scale = static_cast<float>(gui_.scale());
  DebuggerInput input;
  input.mouse_x = (place->x + 0.5F * place->width) * scale;
  input.mouse_y = (place->y + 0.5F * place->height) * scale;
  input.control = name == "speed" || name == "within" || name == "depth";
  constexpr int kUntilUnderMouse = 2;  // frames
  for (int k = 0; k < kUntilUnderMouse; ++k) take_in(input, width_, height_);
  input.buttons[0] = true;
  take_in(input, width_, height_);
  input.buttons[0] = false;
  take_in(input, width_, height_);
}

/// The keys of the tree, the tables and an object's lanes.
void Debugger::take_tree_key(Key key, bool shift) {
  if (key == Key::a) memory_.before_operator = !memory_.before_operator;
  if (key == Key::t) memory_.open_tab = "Tables";
  if (key == Key::t) memory_.table_of = shift ? TableOf::pairs : TableOf::nodes;
  if (key == Key::j) model_.show_object_lanes();
  if (key == Key::a || key == Key::t || key == Key::j) return;
  const TreeWay down = shift ? TreeWay::right : TreeWay::left;
  const TreeWay way = key == Key::u ? TreeWay::up : key == Key::d ? down : TreeWay::across;
  if (const auto node = neighbour_of(model_.run().tree(), node_in(model_.selection()), way))
    model_.select(*node);
}

/// The keys of the lanes below.
void Debugger::take_time_key(Key key, bool shift) {
  Timeline& timeline = model_.timeline;
  const std::size_t lanes = model_.lanes().size();
  switch (key) {
    case Key::plus:
      return model_.zoom_lanes(kZoomOfKey);
    case Key::minus:
      return model_.zoom_lanes(1 / kZoomOfKey);
    case Key::left:
    case Key::right:
      return timeline.window.pan((key == Key::right ? kPanOfWheel : -kPanOfWheel) * timeline.window.span());
    case Key::up:
    case Key::down:
      timeline.lane = (timeline.lane + (key == Key::down ? 1 : lanes - 1)) % lanes;
      return;
    case Key::m:
      return model_.go_to_extreme(!shift);
    case Key::c:
      timeline.clips = !timeline.clips;
      return;
    case Key::r:
      return model_.show_range();
    case Key::s:
      return model_.begin_range();
    case Key::e:
      return model_.end_range();
    case Key::l:
      return model_.toggle_loop();
    case Key::k:
      timeline.kind = neighbour(timeline.kind, !shift);
      return;
    case Key::n:
      return model_.go_to_kind(timeline.kind, !shift);
    default:
      if (const auto digit = digit_of(key)) model_.go_to_kind(kind_of_digit(*digit), !shift);
      return;
  }
}

}  // namespace kerf
