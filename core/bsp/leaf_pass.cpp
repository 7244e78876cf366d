#include "core/bsp/leaf_pass.h"

#include <algorithm>
#include <atomic>

namespace kerf {

template <int D>
void LeafPass<D>::visit_leaves(const Tree<D>& tree, TaskPool& pool, bool dense, const AnyWork& work,
                               PairBuffer& pairs) {
  list_leaves(tree, leaves_);
  scratch_.resize(std::max<std::size_t>(scratch_.size(), pool.threads()));
  for (LeafScratch<D>& scratch : scratch_) scratch.byte_sweep.may_be_dense = dense;
  if (pool.threads() == 1) {
    for (const NodeId leaf : leaves_) work(leaf, scratch_.front(), pairs);
    return;
  }
  cut(tree, pool.pieces());
  std::atomic<std::size_t> joined = 0;  // pieces whose pairs stand behind those of all before them
  pool.for_each(runs_.size(), [&](std::size_t piece, std::size_t thread) {
    const bool is_next = joined.load(std::memory_order_acquire) == piece;
    PairBuffer& found = is_next ? pairs : found_[piece];
    found_[piece].clear();
    for (std::size_t k = runs_[piece].begin; k < runs_[piece].end; ++k)
      work(leaves_[k], scratch_[thread], found);
    if (is_next) joined.store(piece + 1, std::memory_order_release);
  });
  join(joined, pool, pairs);
}

/// Runs of about as many entries each.
template <int D>
void LeafPass<D>::cut(const Tree<D>& tree, std::size_t pieces) {
  runs_.assign(pieces, Slice{});
  found_.resize(std::max(found_.size(), pieces));
  std::uint64_t passed = 0;
  std::size_t next = 0;
  for (std::size_t piece = 0; piece < pieces; ++piece) {
    const std::uint64_t goal = slice(tree.entries(), pieces, piece).end;
    runs_[piece].begin = next;
    while (next < leaves_.size() && (passed < goal || piece + 1 == pieces))
      passed += tree[leaves_[next++]].entries.size();
    runs_[piece].end = next;
  }
}

/// Appends what the pieces from `first` on have found.
template <int D>
void LeafPass<D>::join(std::size_t first, TaskPool& pool, PairBuffer& pairs) {
  std::vector<std::size_t> begins(runs_.size());
  std::size_t total = 0;
  for (std::size_t piece = first; piece < runs_.size(); ++piece) {
    begins[piece] = total;
    total += found_[piece].size();
  }
  Pair* const out = pairs.reserve(total);
  pool.for_each(runs_.size() - first, [&](std::size_t k, std::size_t) {
    const std::size_t piece = first + k;
    std::copy_n(found_[piece].all().data(), found_[piece].size(), out + begins[piece]);
  });
  pairs.commit(total);
}

template class LeafPass<2>;
template class LeafPass<3>;

}  // namespace kerf
