#pragma once

#include "core/related/cut_tree_policy.h"

namespace kerf {

/// A static tree from which what moves is removed, and inserted again where it is now: B. Naylor,
/// "Interactive solid geometry via partitioning trees" (Graphics Interface 1992); Y. Chrysanthou and M.
/// Slater, "Computing dynamic changes to BSP trees" (Eurographics 1992).
///
/// Read for boxes: the tree is built of all objects of the first step and its cuts stay where they are; a
/// leaf that an insertion has made crowded is divided, and a cut below which nothing is left goes.
template <int D>
class ReinsertingTree final : public CutTreePolicy<D> {
 public:
  [[nodiscard]] std::string_view name() const override { return "reinserting-tree"; }

 private:
  using Index = typename CutTree<D>::Index;
  void arrange() override;
  void remove_empty(Index node);
};

}  // namespace kerf
