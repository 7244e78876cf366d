#pragma once

#include <vector>

#include "core/broad_phase/broad_phase.h"
#include "core/broad_phase/object_table.h"

namespace kerf {

/// The oracle: tests every object against every other. Exact by definition, O(n^2).
template <int D>
class BruteForce final : public BroadPhase<D> {
 public:
  [[nodiscard]] std::string_view name() const override { return "brute-force"; }
  Status insert(ObjectId object, const Box<D>& box, Mobility mobility) override;
  Status move(ObjectId object, const Box<D>& box) override;
  Status remove(ObjectId object) override;
  void step() override;
  [[nodiscard]] std::span<const Pair> pairs() const override { return pairs_; }

 private:
  ObjectTable<D> objects_;
  std::vector<Pair> pairs_;
};

extern template class BruteForce<2>;
extern template class BruteForce<3>;

}  // namespace kerf
