#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/geometry/box.h"

namespace kerf {

/// How thick the skin of an object is and since when. It learns: who leaves soon gets a thicker one.
struct Skin {
  static constexpr std::uint8_t kThickest = 6;
  std::uint8_t level = 4;   ///< a sixteenth of the object's size, until it is known better
  std::uint16_t since = 0;  ///< the step, modulo 2^16: a wrong age costs time, never a pair

  /// To be told of each step in which the object left its fat box.
  void left(std::uint32_t step) {
    constexpr std::uint16_t kSoon = 12;
    constexpr std::uint16_t kLate = 200;
    const auto age = static_cast<std::uint16_t>(step - since);
    if (age < kSoon && level < kThickest) ++level;
    if (age > kLate && level > 0) --level;
    since = static_cast<std::uint16_t>(step);
  }
  /// A quarter of the object's size at most.
  [[nodiscard]] float thickness(float size) const { return std::ldexp(size, level - kThickest - 2); }
};

/// The largest extent of a box, and the fastest of its ends since `before`.
struct SizeAndSpeed {
  float size = 0;
  float speed = 0;
};
template <int D>
SizeAndSpeed size_and_speed(const Box<D>& box, const Box<D>& before) {
  SizeAndSpeed result;
  for (int i = 0; i < D; ++i) {
    result.size = std::max(result.size, box.max[i] - box.min[i]);
    result.speed =
        std::max({result.speed, std::abs(box.min[i] - before.min[i]), std::abs(box.max[i] - before.max[i])});
  }
  return result;
}

/// The fat box of an object: it holds `box` and where it will be for some steps if it goes on like from
/// `before`. It grows ahead of the motion by `steps` of it, though never by more than the object's own size,
/// and by the skin on every side, for what shakes or turns. What stands still gets no fat. Box and motion
/// are finite; so is the result.
template <int D>
Box<D> fatten(const Box<D>& box, const Box<D>& before, const Skin& skin, float steps) {
  const auto [size, speed] = size_and_speed(box, before);
  if (speed == 0) return box;
  const float around = std::min(std::max(skin.thickness(size), speed), size);
  Box<D> fat;
  for (int i = 0; i < D; ++i) {
    const float back = std::clamp((before.min[i] - box.min[i]) * steps, 0.0F, size);
    const float ahead = std::clamp((box.max[i] - before.max[i]) * steps, 0.0F, size);
    fat.min[i] = box.min[i] - (back + around);
    fat.max[i] = box.max[i] + (ahead + around);
  }
  return is_valid(fat) ? fat : box;
}

/// The share of the largest skin that one step like that from `before` uses up: 1 leaves it at once.
template <int D>
float share_of_skin(const Box<D>& box, const Box<D>& before) {
  const auto [size, speed] = size_and_speed(box, before);
  return speed < size ? speed / size : (speed > 0 ? 1.0F : 0.0F);
}

}  // namespace kerf
