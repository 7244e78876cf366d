#pragma once

#include <bit>
#include <cstdint>
#include <span>

#include "core/geometry/box.h"

namespace kerf::python {

/// As round_down of core/geometry/box.h for numbers that are not NaN, without a branch, so that a compiler
/// can do several at a time; what is below the range of floats becomes -infinity.
constexpr Scalar float_at_most(double x) {
  const auto near = static_cast<Scalar>(x);
  const auto bits = std::bit_cast<std::int32_t>(near);
  const std::int32_t below =
      near == 0 ? std::bit_cast<std::int32_t>(0x8000'0001U) : bits + (bits < 0 ? 1 : -1);
  return std::bit_cast<Scalar>(static_cast<double>(near) > x ? below : bits);
}

/// As round_up, likewise.
constexpr Scalar float_at_least(double x) { return -float_at_most(-x); }

/// The smallest boxes of floats around those in doubles, each 2 x D numbers.
template <int D>
void round_boxes(std::span<const double> given, std::span<Box<D>> boxes);

}  // namespace kerf::python
