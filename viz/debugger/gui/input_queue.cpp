#include "viz/debugger/gui/input_queue.h"

#include <algorithm>
#include <utility>

#include "core/base/overloaded.h"

namespace kerf {
namespace {

constexpr double kLeastSeconds = 1e-4;  // Dear ImGui needs time to pass

/// The tap of a key, if the action is one.
std::optional<KeyTap> tap_of(const UserAction& action) {
  using Answer = std::optional<KeyTap>;
  return std::visit(
      Overloaded{
          [](const KeyTap& tap) { return Answer(tap); },
          NothingFor<Answer, NothingElse, MouseMove, ButtonChange, WheelTurn, TypedText, DroppedFile>()},
      action.what);
}

bool is_tap(const UserAction& action, Key key) {
  const auto tap = tap_of(action);
  return tap && tap->key == key;
}

/// Two of them in a row have the effect of one.
bool can_be_joined(const UserAction& action) {
  return std::visit(Overloaded{
                        [](const NothingElse&) { return true; },
                        [](const MouseMove&) { return true; },
                        [](const ButtonChange&) { return false; },
                        [](const WheelTurn&) { return true; },
                        [](const KeyTap&) { return false; },
                        [](const TypedText&) { return true; },
                        [](const DroppedFile&) { return false; },
                    },
                    action.what);
}

}  // namespace

/// A keyboard repeats a held key whether or not frames keep up: repeats that would only pile up are dropped.
void InputQueue::add(UserAction action) {
  const auto tap = tap_of(action);
  const auto is_same = [&](const UserAction& waiting) { return is_tap(waiting, tap->key); };
  if (tap && tap->repeated && std::ranges::any_of(actions_, is_same)) return;
  actions_.push_back(std::move(action));
}

bool InputQueue::take_tap(Key key) {
  const auto found = std::ranges::find_if(actions_, [&](const auto& action) { return is_tap(action, key); });
  if (found == actions_.end()) return false;
  actions_.erase(found);
  return true;
}

void InputQueue::apply(const UserAction& action) {
  input_.shift = action.shift;
  input_.control = action.control;
  std::visit(Overloaded{
                 [](const NothingElse&) {},
                 [this](const MouseMove& move) {
                   input_.mouse_x = move.x;
                   input_.mouse_y = move.y;
                 },
                 [this](const ButtonChange& change) { input_.buttons[change.button] = change.down; },
                 [this](const WheelTurn& turn) {
                   input_.wheel += turn.clicks;
                   input_.sideways += turn.sideways;
                 },
                 [this](const KeyTap& tap) { input_.key = tap.key; },
                 [this](const TypedText& text) { input_.text += text.utf8; },
                 [this](const DroppedFile& file) { input_.dropped = file.path; },
             },
             action.what);
}

bool InputQueue::joins_frame(const UserAction& first) const {
  if (actions_.empty() || !can_be_joined(first)) return false;
  const UserAction& next = actions_.front();
  return next.what.index() == first.what.index() && next.shift == first.shift &&
         next.control == first.control;
}

/// The next action is a tap of the key that is down in the last frame: between two taps it has to be up.
bool InputQueue::is_key_held() const {
  return input_.key && !actions_.empty() && is_tap(actions_.front(), *input_.key);
}

DebuggerInput InputQueue::take(double now) {
  const bool waits = is_key_held();
  input_.end_frame();
  double time = waits ? last_ : now;
  if (!waits && !actions_.empty()) {
    const UserAction first = std::move(actions_.front());
    actions_.pop_front();
    apply(first);
    for (time = first.time; joins_frame(first); actions_.pop_front()) {
      apply(actions_.front());
      time = actions_.front().time;
    }
    if (actions_.empty()) time = now;
  }
  input_.seconds = std::max(time - last_, kLeastSeconds);
  last_ = std::max(last_, time);
  return input_;
}

}  // namespace kerf
