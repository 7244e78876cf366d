#pragma once

#include <cstdint>
#include <vector>

namespace kerf {

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
