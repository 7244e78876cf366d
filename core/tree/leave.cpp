#include "core/tree/leave.h"

#include <algorithm>

#include "core/kernels/stay_in_cell.h"
#include "core/tree/cell.h"

namespace kerf {

/// Gives the number of those that stay.
template <int D>
std::size_t LeavePass<D>::take_leavers(Tree<D>& tree, NodeId leaf,
                                       AppendBuffer<std::uint32_t>& leavers) const {
  Node<D>& node = tree[leaf];
  const std::uint32_t axis = node.direction < D ? node.direction : 0;  // if it is none, nobody stays
  const Stayed done =
      stay_in_cell<D>({tree.table.packed().data(), cell_of(tree, leaf), node.right_of, axis,
                       node.entries.data(), node.entries.size(), leavers.reserve(node.entries.size())});
  leavers.commit(done.left);
  return done.stayed;
}

template <int D>
void LeavePass<D>::run(Tree<D>& tree, TaskPool& pool) {
  stayed_.assign(tree.slots(), 0);
  leaves_.clear();
  nodes_.clear();
  for_each_node(tree, tree.root(), [&](NodeId id) {
    nodes_.push_back(id);
    if (tree[id].is_leaf()) leaves_.push_back(id);
  });
  leavers_.resize(std::max(leavers_.size(), pool.pieces()));
  for (AppendBuffer<std::uint32_t>& leavers : leavers_) leavers.clear();
  pool.for_each(pool.pieces(), [&](std::size_t piece, std::size_t) {
    const Slice leaves = slice(leaves_.size(), pool.pieces(), piece);
    for (std::size_t k = leaves.begin; k < leaves.end; ++k)
      stayed_[leaves_[k].index()] =
          static_cast<std::uint32_t>(take_leavers(tree, leaves_[k], leavers_[piece]));
  });
  for (std::size_t piece = 1; piece < leavers_.size(); ++piece)
    leavers_.front().append(leavers_[piece].all());
  for (auto id = nodes_.rbegin(); id != nodes_.rend(); ++id)
    if (!tree[*id].is_leaf())
      stayed_[id->index()] = stayed_[tree[*id].left.index()] + stayed_[tree[*id].right.index()];
}

template class LeavePass<2>;
template class LeavePass<3>;

}  // namespace kerf
