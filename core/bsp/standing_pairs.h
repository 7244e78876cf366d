#pragma once

#include <cstddef>
#include <vector>

#include "core/base/append_buffer.h"
#include "core/kernels/kept_leaf.h"
#include "core/tree/tree.h"

namespace kerf {

/// Whether what is kept in the place of a node is of that node, as long as it is a leaf.
template <int D>
bool is_known(const Tree<D>& tree, const std::vector<KeptLeaf<D>>& leaves, NodeId leaf) {
  return leaf.index() < leaves.size() && leaves[leaf.index()].generation == tree[leaf].generation + 1;
}

/// The standing pairs of all leaves, at the beginning of the pairs of each step: there they stay from one
/// step to the next, so that what rests costs nothing. Each leaf has a stretch. What it loses leaves a hole,
/// which is filled from the end of the step's other pairs; what it gets is one of those, until there is so
/// much of either that all stretches are laid out anew.
template <int D>
class StandingPairs {
 public:
  void clear() { size_ = wrong_ = 0; }
  /// Leaves in `pairs`, which are those of the step before or none, nothing but the stretches.
  void begin_step(const Tree<D>& tree, std::vector<KeptLeaf<D>>& leaves, PairBuffer& pairs);
  /// To be told when the other pairs are appended and all leaves are up to date.
  void end_step(const Tree<D>& tree, std::vector<KeptLeaf<D>>& leaves, PairBuffer& pairs);

 private:
  void lay_out(const Tree<D>& tree, std::vector<KeptLeaf<D>>& leaves, bool others, PairBuffer& pairs);
  void close_holes(const Tree<D>& tree, std::vector<KeptLeaf<D>>& leaves, PairBuffer& pairs);

  std::size_t size_ = 0;   ///< of all stretches
  std::size_t wrong_ = 0;  ///< pairs that lie in holes or behind the stretches
  PairBuffer behind_;
};

extern template class StandingPairs<2>;
extern template class StandingPairs<3>;

}  // namespace kerf
