#pragma once

#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/kernels/radix_sort.h"

namespace kerf {

/// Which pairs began and which ended from step to step, for engines that keep contacts and need only the
/// changes. It serves any broad phase, and costs nothing unless it is used: the pairs are ordered by counting
/// and compared with those of the step before.
class PairChanges {
 public:
  /// Call it with the complete set of each step, no pair twice. Before the first step there were none.
  void update(std::span<const Pair> pairs);
  /// Pairs of the last step that the one before did not have, in ascending order.
  [[nodiscard]] std::span<const Pair> begun() const { return begun_; }
  /// Pairs of the step before that the last one does not have, in ascending order.
  [[nodiscard]] std::span<const Pair> ended() const { return ended_; }

 private:
  void order(std::span<const Pair> pairs);

  RadixSort sort_;
  std::vector<Pair> before_;
  std::vector<Pair> now_;  ///< in ascending order, as before_
  std::vector<Pair> begun_;
  std::vector<Pair> ended_;
};

}  // namespace kerf
