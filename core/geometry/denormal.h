#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "core/geometry/vector.h"

namespace kerf {

// Arithmetic that keeps denormals, also on a processor that takes them for zero: as the caller may have
// chosen.

/// A float as it is.
constexpr double wide(Scalar x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  constexpr std::uint32_t kExponent = 0x7F800000U;
  constexpr std::uint32_t kFraction = 0x007FFFFFU;
  if ((bits & kExponent) != 0) [[likely]]
    return static_cast<double>(x);
  const double size = static_cast<double>(bits & kFraction) * 0x1p-149;
  return (bits >> 31U) != 0 ? -size : size;
}

/// The sum of two floats, rounded to a float.
inline Scalar plus(Scalar a, Scalar b) {
  const Scalar usual = a + b;
  if (!(std::abs(usual) < 0x1p-100F)) [[likely]]  // a denormal is less than half of its last place
    return usual;
  const double sum = wide(a) + wide(b);
  if (std::abs(sum) >= 0x1p-126) return static_cast<Scalar>(sum);
  const auto size = static_cast<std::uint32_t>(std::abs(sum) * 0x1p149);  // exact, as such sums are
  return std::bit_cast<Scalar>(size | (std::signbit(sum) ? 0x80000000U : 0U));
}

}  // namespace kerf
