#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/append_buffer.h"
#include "core/base/task_pool.h"
#include "core/bsp/ordered_sweep.h"
#include "core/kernels/byte_sweep.h"
#include "core/tree/tree.h"

namespace kerf {

/// The memory of one thread that looks for the pairs of leaves, kept between steps.
template <int D>
struct LeafScratch {
  SweepBuffer<D> ordered;  ///< of ordered leaves
  // Of leaves that are swept, or keep pairs.
  LeafView<D> view;
  ByteSweep<D> byte_sweep;
  // Of leaves that keep pairs.
  PairBuffer pairs;
  std::vector<PackedBox<D>> gathered;
  std::vector<std::uint8_t> marks;    ///< by object; all are 0 between leaves
  std::vector<std::uint8_t> has_fat;  ///< by entry of one leaf
};

/// One visit to each leaf of a tree. Leaves are the unit of parallel work (DESIGN.md, "Speed"): threads take
/// runs of them, and their pairs are joined in the order of the leaves, so that the number of threads
/// affects only the time.
template <int D>
class LeafPass {
 public:
  /// Calls `work(leaf, scratch, pairs)`, which appends the pairs of the leaf to the buffer. It may change
  /// that leaf and nothing shared. `dense`: bytes may decide pairs without a test of floats.
  template <class Work>
  void run(const Tree<D>& tree, TaskPool& pool, bool dense, Work work, PairBuffer& pairs) {
    visit_leaves(tree, pool, dense, std::ref(work), pairs);
  }

 private:
  using AnyWork = std::function<void(NodeId leaf, LeafScratch<D>& scratch, PairBuffer& pairs)>;
  void visit_leaves(const Tree<D>& tree, TaskPool& pool, bool dense, const AnyWork& work, PairBuffer& pairs);
  void cut(const Tree<D>& tree, std::size_t pieces);
  void join(std::size_t first, TaskPool& pool, PairBuffer& pairs);

  std::vector<NodeId> leaves_;
  std::vector<Slice> runs_;        ///< of leaves, by piece
  std::vector<PairBuffer> found_;  ///< by piece, until its place among all pairs is known
  std::vector<LeafScratch<D>> scratch_;
};

}  // namespace kerf
