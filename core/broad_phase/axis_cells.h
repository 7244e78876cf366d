#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/geometry/vector.h"

namespace kerf {

/// Equal cells along an axis. Rounding is monotone, so boxes that overlap reach a common one wherever they
/// lie.
class AxisCells {
 public:
  AxisCells() = default;
  /// `count` cells between two coordinates; one where the scene is too thin for a float to scale.
  AxisCells(Scalar low, Scalar high, std::uint32_t count) {
    const double length = static_cast<double>(high) - low;
    const double scale = length > 0 ? count / length : 0;
    if (count < 2 || !(scale > 0 && scale <= std::numeric_limits<Scalar>::max())) return;
    count_ = count;
    last_ = static_cast<Scalar>(count - 1);
    scale_ = static_cast<Scalar>(scale);
    offset_ = low * scale_;
  }
  [[nodiscard]] std::uint32_t count() const { return count_; }
  /// The cell of a coordinate; beyond the ends the first or the last.
  [[nodiscard]] std::uint32_t cell(Scalar x) const {
    const Scalar place = x * scale_ - offset_;
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::min(std::max(place, Scalar{0}), last_)));
  }
  /// Where a cell begins: its least coordinate. Infinite for the first, and beyond the last.
  [[nodiscard]] Scalar begin(std::uint32_t which) const;

 private:
  Scalar scale_ = 0;
  Scalar offset_ = 0;
  Scalar last_ = 0;
  std::uint32_t count_ = 1;
};

/// Found by halving the floats, which agrees with `cell` whatever that rounds.
inline Scalar AxisCells::begin(std::uint32_t which) const {
  if (which == 0) return -std::numeric_limits<Scalar>::infinity();
  if (which >= count_) return std::numeric_limits<Scalar>::infinity();
  // Places in the order of finite floats: negative ones are those of the magnitude.
  const auto float_at = [](std::int64_t place) {
    const Scalar size = std::bit_cast<Scalar>(static_cast<std::uint32_t>(std::abs(place)));
    return place < 0 ? -size : size;
  };
  std::int64_t high = std::bit_cast<std::uint32_t>(std::numeric_limits<Scalar>::max());
  std::int64_t low = -high;
  while (low < high) {
    const std::int64_t middle = low + (high - low) / 2;
    if (cell(float_at(middle)) >= which) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return float_at(low);
}

}  // namespace kerf
