#pragma once

#include "core/related/cut_tree_policy.h"

namespace kerf {

/// A kd-tree whose cuts follow the objects, built anew now and then: J. Snyder and J. Lengyel, "Visibility
/// sorting and compositing without splitting for image layer decompositions" (SIGGRAPH 1998).
///
/// Read for boxes: in each step every cut, from the root down, goes to the mean of the centres of the objects
/// below it; which axis a node cuts, and which nodes there are, changes only when the tree is built anew.
template <int D>
class ShiftingCuts final : public CutTreePolicy<D> {
 public:
  static constexpr std::uint32_t kRebuiltEvery = 100;  ///< steps; 0 would be never
  explicit ShiftingCuts(std::uint32_t rebuilt_every = kRebuiltEvery) : rebuilt_every_(rebuilt_every) {}

  [[nodiscard]] std::string_view name() const override { return "shifting-cuts"; }

 private:
  using Index = typename CutTree<D>::Index;
  void arrange() override;
  void shift(Index node, std::vector<ObjectId> objects);

  std::uint32_t rebuilt_every_;
  std::uint32_t age_ = 0;  ///< steps since it was built
};

}  // namespace kerf
