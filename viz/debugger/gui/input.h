#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

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
  digit_0,  // to 9, in order
  digit_1,
  digit_2,
  digit_3,
  digit_4,
  digit_5,
  digit_6,
  digit_7,
  digit_8,
  digit_9,
  n,
  k,
  s,
  e,
  l,
  a,  // the tree and the tables
  u,
  d,
  x,
  t,
  j,
  g,  // the legend
  v,  // directions of the view; with Ctrl: paste
  p,  // the search
  w,  // errors
  q,  // queries
  y,  // changes of the view
  z,
  f1,
  f5,
  f9,
  f10,
  f12,
  count,
};

/// The digit of a key; none if it has another meaning.
constexpr std::optional<int> digit_of(Key key) {
  if (key < Key::digit_0 || key > Key::digit_9) return std::nullopt;
  return static_cast<int>(key) - static_cast<int>(Key::digit_0);
}
constexpr Key key_of_digit(int digit) { return static_cast<Key>(static_cast<int>(Key::digit_0) + digit); }

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
  std::string dropped;        ///< path of a file that was dropped on the window
  double seconds = 1.0 / 60;  ///< since the last frame

  /// Ends what lasts for one frame; what is held stays.
  void end_frame() {
    wheel = sideways = 0;
    key.reset();
    text.clear();
    dropped.clear();
  }
};

/// The shape of the mouse pointer over what it can do.
enum class Pointer : std::uint8_t { arrow, text, across, down, hand };
inline constexpr std::array<std::string_view, 5> kPointerNames{"arrow", "text", "across", "down", "hand"};

}  // namespace kerf
