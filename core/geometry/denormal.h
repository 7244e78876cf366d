#pragma once

#include <bit>
#include <cstdint>

#include "core/geometry/vector.h"

namespace kerf {

/// A float as it is, also if it is a denormal and the processor takes those for zero, as the caller may have
/// chosen.
constexpr double wide(Scalar x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  constexpr std::uint32_t kExponent = 0x7F800000U;
  constexpr std::uint32_t kFraction = 0x007FFFFFU;
  if ((bits & kExponent) != 0) [[likely]]
    return static_cast<double>(x);
  const double size = static_cast<double>(bits & kFraction) * 0x1p-149;
  return (bits >> 31U) != 0 ? -size : size;
}

}  // namespace kerf
