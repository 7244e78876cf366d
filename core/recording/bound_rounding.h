#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "core/base/counted.h"
#include "core/geometry/given_box.h"

namespace kerf {

/// How the program that wrote another engine's boxes rounded their bounds: to significant digits (%g) or to
/// decimals (%f). Neither: the text has all of each number.
struct BoundRounding {
  std::uint32_t digits = 0;    ///< significant ones; 0: it did not round to these
  std::uint32_t decimals = 0;  ///< 0: it did not round to these
  bool floats = false;         ///< the numbers were floats, else doubles
  std::uint32_t planes = 0;    ///< bit k: all boxes are flat at one number along axis k
  friend bool operator==(const BoundRounding&, const BoundRounding&) = default;
};

/// "6 digits", "3 decimals"
inline std::string to_text(const BoundRounding& rounding) {
  return rounding.decimals > 0 ? counted(rounding.decimals, "decimal") : counted(rounding.digits, "digit");
}

/// The most that was rounded away of a bound: half a unit of its last place, or 0 if only one number of the
/// engine's kind has this text.
inline double lost_of(const BoundRounding& rounding, double bound) {
  if (rounding == BoundRounding{} || !std::isfinite(bound)) return 0;
  if (rounding.decimals == 0 && (rounding.digits == 0 || bound == 0)) return 0;
  const double size = std::abs(bound);
  const double place = rounding.decimals > 0
                           ? -static_cast<double>(rounding.decimals)
                           : std::floor(std::log10(size)) + 1 - static_cast<double>(rounding.digits);
  const double unit = std::pow(10.0, place);
  const auto as_float = static_cast<Scalar>(std::min(size, double{std::numeric_limits<Scalar>::max()}));
  const double spacing = rounding.floats ? static_cast<double>(as_float - std::nextafter(as_float, Scalar{0}))
                                         : size - std::nextafter(size, 0.0);
  return bound != 0 && unit < spacing ? 0 : unit / 2;
}

/// Of boxes that overlap as written: an axis on which what was rounded away decides; none: they overlap.
/// Rounding keeps the order of numbers, so that only bounds with the same text may have been apart, and boxes
/// that are apart as written are apart. An axis along which all boxes of the file are flat at one text, as in
/// 2D data with a z, decides nothing; two walls or points with the same text may be apart.
template <int D>
std::optional<int> undecided_axis(const BoundRounding& rounding, const GivenBox<D>& a, const GivenBox<D>& b) {
  if (rounding == BoundRounding{}) return std::nullopt;
  for (std::size_t i = 0; i < D; ++i) {
    const bool are_flat = a.min[i] == a.max[i] && b.min[i] == b.max[i];
    if (are_flat && (rounding.planes >> i & 1U) != 0) continue;
    const bool touch_at_a = a.min[i] == b.max[i] && lost_of(rounding, a.min[i]) > 0;
    const bool touch_at_b = b.min[i] == a.max[i] && lost_of(rounding, b.min[i]) > 0;
    if (touch_at_a || touch_at_b) return static_cast<int>(i);
  }
  return std::nullopt;
}

/// The box, larger on each side by what may have been rounded away there.
template <int D>
GivenBox<D> widen(GivenBox<D> box, const BoundRounding& rounding) {
  for (double& min : box.min) min -= lost_of(rounding, min);
  for (double& max : box.max) max += lost_of(rounding, max);
  return box;
}

}  // namespace kerf
