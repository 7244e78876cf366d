#pragma once

#include "core/related/cut_tree_policy.h"

namespace kerf {

/// Planes between groups of objects, so that what moves in one group concerns only its own tree: E. Torres,
/// "Optimization of the binary space partition algorithm (BSP) for the visualization of dynamic scenes"
/// (Eurographics 1990).
///
/// Read for boxes: auxiliary cuts go through gaps where no object is, as near to the middle of the objects as
/// gaps are, until a group is small; each group has a tree of its own. In a step only trees of groups that an
/// object is in that has moved are built anew. The auxiliary cuts are chosen anew when more than a tenth of
/// the objects are in two groups and more, or there are twice as many as then.
template <int D>
class AuxiliaryPlanes final : public CutTreePolicy<D> {
 public:
  static constexpr std::size_t kGroup = 64;       ///< objects that need no further auxiliary cut
  static constexpr double kMostStraddlers = 0.1;  ///< of the objects
  [[nodiscard]] std::string_view name() const override { return "auxiliary-planes"; }
  /// Groups in the last step, and those of them whose trees were built anew.
  [[nodiscard]] std::size_t groups() const { return groups_.size(); }
  [[nodiscard]] std::size_t rebuilt_groups() const { return rebuilt_; }

 private:
  using Index = typename CutTree<D>::Index;
  using Cut = typename CutTree<D>::Cut;
  using Changes = typename CutTreePolicy<D>::Changes;
  void arrange() override;
  void choose_planes();
  /// The trees of groups in which something has changed.
  void build_again(const std::vector<Index>& dirty, const Changes& changes);
  /// The gap nearest to the middle on any axis; none if there is no gap.
  [[nodiscard]] Cut gap_of(Index leaf) const;
  /// The groups that a box reaches into.
  void find_groups(const Box<D>& box, std::vector<Index>& groups) const;

  std::vector<Index> groups_;           ///< nodes below the auxiliary cuts
  std::vector<std::uint8_t> is_group_;  ///< by node
  std::size_t rebuilt_ = 0;
  std::size_t placed_then_ = 0;  ///< objects when the planes were chosen
  std::size_t members_ = 0;      ///< of all groups
};

}  // namespace kerf
