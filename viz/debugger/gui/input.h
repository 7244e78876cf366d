#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace kerf {

/// A key with a meaning in the debugger, beside those that write text.
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
  c,
  m,
  r,
  question,
  escape,
  enter,
  backspace,
  del,
  left,
  right,
  tab,
  up,
  down,
  plus,
  minus,
  f1,
  f5,
  f9,
  f12,
  count,
};

/// The user's actions since the last frame, from a window or from a script.
struct DebuggerInput {
  float mouse_x = -1;
  float mouse_y = -1;
  std::array<bool, 3> buttons{};  ///< left, right, middle: held now
  float wheel = 0;
  float sideways = 0;  ///< turns of a wheel to the side, positive to the left
  bool shift = false;
  bool control = false;
  std::optional<Key> key;     ///< that went down
  std::string text;           ///< typed, in UTF-8
  double seconds = 1.0 / 60;  ///< since the last frame

  /// Ends what lasts for one frame; what is held stays.
  void end_frame() {
    wheel = sideways = 0;
    key.reset();
    text.clear();
  }
};

}  // namespace kerf
