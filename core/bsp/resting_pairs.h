#pragma once

#include <cstddef>

#include "core/base/append_buffer.h"
#include "core/bsp/leaf_cache.h"
#include "core/kernels/kept_leaf.h"
#include "core/tree/tree.h"

namespace kerf {

/// What is kept of each leaf.
template <int D>
using KeptLeaves = LeafCache<D, KeptLeaf<D>>;

/// The resting pairs of all leaves, at the beginning of the pairs of each step: there they stay from one
/// step to the next, so that objects at rest cost nothing. Each leaf has a stretch. A pair that it loses
/// leaves a hole, which is filled from the end of the step's other pairs; a pair that it gets is one of
/// those, until there are so many of either that all stretches are laid out anew.
template <int D>
class RestingPairs {
 public:
  void clear() { size_ = wrong_ = 0; }
  /// `pairs` has those of the last step, or none. Afterwards it has nothing but the stretches.
  void begin_step(const Tree<D>& tree, KeptLeaves<D>& leaves, PairBuffer& pairs);
  /// Call it when the other pairs are appended and all leaves are up to date.
  void end_step(const Tree<D>& tree, KeptLeaves<D>& leaves, PairBuffer& pairs);

 private:
  void lay_out(const Tree<D>& tree, KeptLeaves<D>& leaves, bool others, PairBuffer& pairs);
  void close_holes(const Tree<D>& tree, KeptLeaves<D>& leaves, PairBuffer& pairs);

  std::size_t size_ = 0;   ///< of all stretches
  std::size_t wrong_ = 0;  ///< pairs that lie in holes or behind the stretches
  PairBuffer behind_;
};

}  // namespace kerf
