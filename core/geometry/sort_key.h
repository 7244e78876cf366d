#pragma once

#include <bit>
#include <cstdint>

#include "core/geometry/vector.h"

namespace kerf {

/// A float's place in the order of floats, as an unsigned number. -0 comes before +0.
inline std::uint32_t sort_key(Scalar x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  return bits ^ ((bits >> 31U) != 0 ? 0xFFFFFFFFU : 0x80000000U);
}

}  // namespace kerf
