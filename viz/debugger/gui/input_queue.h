#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <variant>

#include "viz/debugger/gui/input.h"

namespace kerf {

/// The mouse is at a pixel of the picture.
struct MouseMove {
  float x = 0;
  float y = 0;
};
struct ButtonChange {
  std::size_t button = 0;  ///< see DebuggerInput
  bool down = false;
};
struct WheelTurn {
  float clicks = 0;
  float sideways = 0;
};
struct KeyTap {
  Key key = Key::space;
  bool repeated = false;  ///< by a keyboard whose key is held
};
struct TypedText {
  std::string utf8;
};
/// A file was dropped on the window.
struct DroppedFile {
  std::string path;
};
/// No action of its own: only held keys and buttons, or the window has to be drawn again.
struct NothingElse {};

/// One action of the user, and what was held during it.
struct UserAction {
  double time = 0;  ///< in seconds
  bool shift = false;
  bool control = false;
  std::variant<NothingElse, MouseMove, ButtonChange, WheelTurn, KeyTap, TypedText, DroppedFile> what;
};

/// The user's actions, in order, until frames take them in. Dear ImGui 1.86 sees one state each frame, not
/// what happened in between, so a frame gets one action: a button that goes down and up between two frames is
/// down in the first and up in the second. Only moves, turns of the wheel and letters that follow each other
/// are joined. Frames that are behind pass the time of their actions, so that a double click stays one.
class InputQueue {
 public:
  void add(UserAction action);
  [[nodiscard]] bool is_empty() const { return actions_.empty(); }
  /// Removes one waiting tap of that key; false if there is none.
  bool take_tap(Key key);
  /// Input of the next frame, which is drawn at `now`.
  [[nodiscard]] DebuggerInput take(double now);

 private:
  void apply(const UserAction& action);
  [[nodiscard]] bool joins_frame(const UserAction& first) const;
  [[nodiscard]] bool is_key_held() const;

  std::deque<UserAction> actions_;
  DebuggerInput input_;  ///< of the last frame
  double last_ = 0;      ///< time up to which frames were taken
};

}  // namespace kerf
