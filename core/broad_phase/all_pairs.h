#pragma once

#include "core/broad_phase/tabled.h"
#include "core/kernels/lanes.h"
#include "core/objects/structure.h"

namespace kerf {

/// Brute force at its fastest: every box against every other, a vector of them at a time. BruteForce is the
/// same without vectors, as readable as the definition of a pair.
template <int D>
class AllPairs final : public Tabled<D>, public SelfDescribing<D> {
 public:
  [[nodiscard]] std::string_view name() const override { return "all-pairs"; }
  /// Has no structure: describes only how many tests that takes.
  void describe(StructureParts<D>& parts) const override {
    tell_each_with_each(this->placed().size(), parts);
  }

 private:
  void find_pairs(PairList& pairs) override;

  Lanes<D> lanes_;
};

}  // namespace kerf
