#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "core/base/ids.h"

namespace kerf {

/// The pairs of a leaf that hold until one of their objects moves, and where the first of them have their
/// place among the pairs of every step (see RestingPairs).
struct RestingList {
  std::vector<Pair> pairs;
  std::size_t place = 0;               ///< of the first, among the pairs of a step
  std::size_t room = 0;                ///< number of pairs that have their place there
  std::vector<std::uint32_t> changed;  ///< places of `pairs` that differ from what was put there

  void push_back(const Pair& pair) {
    if (pairs.size() < room) changed.push_back(static_cast<std::uint32_t>(pairs.size()));
    pairs.push_back(pair);
  }
  /// Call it when all pairs are others than before.
  void all_changed() {
    changed.resize(std::min(pairs.size(), room));
    std::iota(changed.begin(), changed.end(), 0U);
  }
  /// The pairs that have no place yet.
  [[nodiscard]] std::span<const Pair> others() const {
    return std::span(pairs).subspan(room < pairs.size() ? room : pairs.size());
  }
};

}  // namespace kerf
