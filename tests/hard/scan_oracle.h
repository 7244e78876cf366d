#pragma once

#include <vector>

#include "core/broad_phase/brute_force.h"

namespace kerf::test {

/// The oracle for many objects: tests each pair that overlaps along one axis. Exact as brute force is, and
/// nearly as plain: boxes in the order of their lower ends, each against those that begin before it ends.
template <int D>
class ScanOracle final : public BruteForce<D> {
 public:
  using BruteForce<D>::BruteForce;
  [[nodiscard]] std::string_view name() const override { return "scan"; }
  /// Finds the pairs in the order of `Pair`.
  void step() override;

 private:
  [[nodiscard]] int best_axis(const std::vector<ObjectId>& placed) const;
};

}  // namespace kerf::test
