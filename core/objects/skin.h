#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "core/base/tuning.h"
#include "core/geometry/box.h"
#include "core/geometry/packed_box.h"

namespace kerf {

/// How thick the skin of an object is and since when. It learns: an object that leaves its fat box soon gets
/// a thicker skin. An object that moves by more than the thickest skin in a step is *restless*, and has no
/// skin until it was slow for some steps. Its numbers are in `tuning.h`.
struct Skin {
  static constexpr std::uint8_t kThickest = tuning::kThickestSkin;
  static constexpr float kMost = tuning::kMostSkin;  ///< thickness of the thickest, over the object's size
  static constexpr std::uint8_t kRestless = tuning::kRestlessSteps;
  std::uint8_t level = kThickest;  ///< until more is known
  bool wrapped = false;            ///< it was wrapped since it left last
  std::uint8_t wraps = 0;          ///< how often it left soon after it had been wrapped
  std::uint8_t restless = 0;       ///< slow steps for which it still counts as restless
  std::uint16_t since = 0;         ///< the step, modulo 2^16: a wrong age costs time, never a pair
  std::uint16_t seen = 0;          ///< the fingerprint of its box at the last look

  [[nodiscard]] std::uint16_t age(std::uint32_t step) const {
    return static_cast<std::uint16_t>(step - since);
  }
  /// Call it for each step in which the object gets another fat box. `had_fat`: the one that it left was
  /// larger than its box; only then its age says how thick the next one must be.
  void left(std::uint32_t step, bool had_fat) {
    const bool is_soon = age(step) < tuning::kSoonLeave;
    if (had_fat && is_soon && level < kThickest) ++level;
    if (had_fat && age(step) > tuning::kLateLeave && level > 0) --level;
    if (wrapped) wraps = is_soon ? std::min<std::uint8_t>(wraps + 1, tuning::kMostWraps) : 0;
    wrapped = false;
    since = static_cast<std::uint16_t>(step);
  }
  /// Call it for the same steps, and for every step of a restless object. `fast`: it moved by more than the
  /// thickest skin.
  void moved(bool fast) {
    restless = fast ? kRestless : static_cast<std::uint8_t>(std::max(restless - 1, 0));
  }
  /// Whether the box has the fingerprint of the last look. A mistake costs time, never a pair.
  [[nodiscard]] bool is_unmoved(std::uint16_t fingerprint) const { return seen == fingerprint; }
  void look(std::uint16_t fingerprint) { seen = fingerprint; }
  [[nodiscard]] bool is_restless() const { return restless > 0; }
  /// Whether the object stayed so long that it should be wrapped in its skin, whatever fat it has. The wait
  /// doubles each time that it left soon after.
  [[nodiscard]] bool is_at_rest(std::uint32_t step) const { return age(step) >= tuning::kRestSteps << wraps; }
  /// Call it when the object gets its skin as its fat box.
  void wrap(std::uint32_t step) {
    wrapped = true;
    since = static_cast<std::uint16_t>(step);
  }
  [[nodiscard]] float thickness(float size) const { return std::ldexp(kMost * size, level - kThickest); }
  friend bool operator==(const Skin&, const Skin&) = default;
};

/// 16 bits that depend on all bits of a box, the same on every machine.
template <int D>
std::uint16_t fingerprint(const PackedBox<D>& box) {
  constexpr std::uint32_t kGolden = 0x9E3779B9U;
  std::uint32_t mixed = 0;
  for (const Scalar lane : box.lane) mixed = (mixed ^ std::bit_cast<std::uint32_t>(lane)) * kGolden;
  return static_cast<std::uint16_t>(mixed >> 16U);
}

/// The second largest extent of a box, and the fastest of its ends since `before`. By its largest extent, a
/// long rod's skin would make it many times as wide and give it as many more candidates.
struct SizeAndSpeed {
  float size = 0;
  float speed = 0;

  /// Whether the object moved by more than any skin. It would leave any fat box soon, and have many
  /// candidates until then.
  [[nodiscard]] bool is_fast() const { return speed > 0 && speed >= Skin::kMost * size; }
  /// The speed over the size, 1 at most.
  [[nodiscard]] float relative_speed() const {
    return speed < size ? speed / size : (speed > 0 ? 1.0F : 0.0F);
  }
};
template <int D>
[[gnu::always_inline]] inline SizeAndSpeed size_and_speed(const PackedBox<D>& box,
                                                          const PackedBox<D>& before) {
  SizeAndSpeed result;
  float largest = 0;
  for (std::size_t i = 0; i < D; ++i) {
    const float extent = -box.lane[PackedBox<D>::kHalf + i] - box.lane[i];
    result.size = std::max(result.size, std::min(largest, extent));
    largest = std::max(largest, extent);
  }
  for (std::size_t i = 0; i < box.lane.size(); ++i)
    result.speed = std::max(result.speed, std::abs(box.lane[i] - before.lane[i]));
  return result;
}
template <int D>
SizeAndSpeed size_and_speed(const Box<D>& box, const Box<D>& before) {
  return size_and_speed(PackedBox<D>(box), PackedBox<D>(before));
}

/// The share of the way ahead that an object gets in its fat box. Shares differ, since objects that move
/// alike would otherwise all leave their fat boxes in the same step.
inline float fat_share(std::uint32_t object) {
  constexpr std::uint32_t kGolden = 0x9E3779B9U;  // consecutive objects get shares far apart
  constexpr float kLeast = tuning::kLeastShareAhead;
  return kLeast + (1 - kLeast) * static_cast<float>((object * kGolden) >> 8U) * 0x1p-24F;
}

/// The fat box of an object: it holds `box`, and the boxes of some steps to come if the object goes on as it
/// did since `before`. It grows ahead of the motion by a `share` of `steps` steps, by the object's own size
/// at most, and by the skin on every side, for objects that shake or turn. An object that stands still gets
/// no fat, nor does a fast one. Box and motion are finite; so is the result.
template <int D>
Box<D> fatten(const Box<D>& box, const Box<D>& before, const Skin& skin, float steps, float share) {
  const auto [size, speed] = size_and_speed(box, before);
  if (speed == 0 || speed >= Skin::kMost * size) return box;
  const float around = std::max(skin.thickness(size), speed);
  Box<D> fat;
  for (int i = 0; i < D; ++i) {
    const float back = std::clamp((before.min[i] - box.min[i]) * steps, 0.0F, size) * share;
    const float ahead = std::clamp((box.max[i] - before.max[i]) * steps, 0.0F, size) * share;
    fat.min[i] = box.min[i] - (back + around);
    fat.max[i] = box.max[i] + (ahead + around);
  }
  return is_valid(fat) ? fat : box;
}

/// The fat box of an object that stayed where it is for long: the skin on every side.
template <int D>
Box<D> wrap(const Box<D>& box, const Skin& skin) {
  const float around = skin.thickness(size_and_speed(box, box).size);
  Box<D> fat = box;
  for (int i = 0; i < D; ++i) {
    fat.min[i] = box.min[i] - around;
    fat.max[i] = box.max[i] + around;
  }
  return is_valid(fat) ? fat : box;
}

/// Whether a fat box is larger than any skin: its object was fast when it was made.
template <int D>
bool is_for_flight(const Box<D>& fat, const Box<D>& box) {
  const auto [size, margin] = size_and_speed(box, fat);
  return margin > tuning::kFlightMargin * Skin::kMost * size;
}

}  // namespace kerf
