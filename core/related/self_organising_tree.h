#pragma once

#include "core/related/cut_tree_policy.h"

namespace kerf {

/// A tree that is divided only where it is used, and forgets what is used no more: S. Ar, G. Montag and A.
/// Tal, "Deferred, self-organizing BSP trees" (Eurographics 2002); S. Ar, B. Chazelle and A. Tal,
/// "Self-customized BSP trees for collision detection" (Computational Geometry, 2000).
///
/// Read for boxes: a use of a leaf is a comparison of two of its boxes, and uses of the past count half as
/// much in each further step. A leaf is divided when its uses would have paid for that, one cut a step; two
/// leaves become one again when moving objects between them costs more than comparing them would.
template <int D>
class SelfOrganisingTree final : public CutTreePolicy<D> {
 public:
  static constexpr double kForget = 0.5;       ///< of uses and updates, in each step
  static constexpr double kPriceOfCut = 12;    ///< uses for each entry that is divided
  static constexpr double kPriceOfUpdate = 4;  ///< uses for each entry that is removed or inserted
  [[nodiscard]] std::string_view name() const override { return "self-organising-tree"; }

 private:
  using Index = typename CutTree<D>::Index;
  void arrange() override;
  void organise(Index node);
};

}  // namespace kerf
