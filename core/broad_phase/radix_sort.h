#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "core/geometry/vector.h"

namespace kerf {

/// A float's place in the order of floats, as an unsigned number. -0 comes before +0.
inline std::uint32_t sort_key(Scalar x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  return bits ^ ((bits >> 31U) != 0 ? 0xFFFFFFFFU : 0x80000000U);
}

/// Sorts numbers below 2^32 that carry another 32 bits: stable, in three passes over 11 bits each,
/// independent of how the keys are spread.
class RadixSort {
 public:
  struct Item {
    std::uint32_t key;
    std::uint32_t value;
  };

  /// The caller fills it.
  std::vector<Item> items;
  void sort();

 private:
  std::vector<Item> other_;
};

}  // namespace kerf
