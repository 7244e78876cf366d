#pragma once

#include <cstdint>

namespace kerf {

/// 8-bit colour; alpha 255 is opaque.
struct Color {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  std::uint8_t a = 255;
  friend constexpr bool operator==(const Color&, const Color&) = default;
};

constexpr std::uint8_t to_byte(double x) {
  return x <= 0 ? std::uint8_t{0} : x >= 255 ? std::uint8_t{255} : static_cast<std::uint8_t>(x + 0.5);
}

/// `a` at t = 0, `b` at t = 1.
constexpr Color mix(Color a, Color b, double t) {
  return {to_byte(a.r + (b.r - a.r) * t), to_byte(a.g + (b.g - a.g) * t), to_byte(a.b + (b.b - a.b) * t),
          to_byte(a.a + (b.a - a.a) * t)};
}

/// Opacity from 0 to 1.
constexpr Color with_alpha(Color color, double alpha) {
  color.a = to_byte(255 * alpha);
  return color;
}

/// Light on a face: 1 leaves the colour as it is.
constexpr Color lit(Color color, double light) {
  return {to_byte(color.r * light), to_byte(color.g * light), to_byte(color.b * light), color.a};
}

}  // namespace kerf
