#pragma once

#include <cstdint>
#include <vector>

#include "core/base/random.h"

namespace kerf::test {

/// A random fuzz case; long ones grow deep trees.
inline std::vector<std::uint8_t> random_case(std::uint64_t seed) {
  Random random(seed);
  std::vector<std::uint8_t> bytes(64U << random.below(7));
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.below(256));
  return bytes;
}

}  // namespace kerf::test
