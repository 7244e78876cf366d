#pragma once

#include <array>
#include <string>
#include <vector>

namespace kerf {

/// A key that the debugger knows, beside those that write text.
enum class Key : std::uint8_t {
  space,
  comma,
  period,
  home,
  end,
  f,
  h,
  i,
  b,
  o,
  question,
  escape,
  enter,
  backspace,
  del,
  left,
  right,
  tab,
  f1,
  f5,
  f9,
  f12,
  count,
};

/// A key going down, with what is held beside it.
struct KeyPress {
  Key key = Key::space;
  bool shift = false;
  bool control = false;
};

/// What the user did since the last frame, whoever he is: a window's or a script's.
struct DebuggerInput {
  float mouse_x = -1;
  float mouse_y = -1;
  std::array<bool, 3> buttons{};  ///< left, right, middle: held now
  float wheel = 0;
  bool shift = false;
  bool control = false;
  std::vector<KeyPress> keys;  ///< that went down
  std::string text;            ///< typed, in UTF-8
  float seconds = 1.0F / 60;   ///< since the last frame
};

}  // namespace kerf
