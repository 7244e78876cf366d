#include "core/tree/leave.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/kernels/stay_in_cell.h"

namespace kerf {
namespace {

constexpr Scalar kInfinity = std::numeric_limits<Scalar>::infinity();

/// The boxes that `classify` sends to this leaf and to no other, as a packed box around them. What lies
/// beside a partitioner along no axis is not told apart: such a cell holds nothing.
template <int D>
PackedBox<D> cell_of(const Tree<D>& tree, NodeId leaf) {
  PackedBox<D> cell;
  cell.lane.fill(-kInfinity);
  for (NodeId id = tree[leaf].parent; !id.is_none(); id = tree[id].parent) {
    const Node<D>& node = tree[id];
    if (node.direction >= D) {
      cell.lane.fill(kInfinity);
      break;
    }
    const bool right = (tree[leaf].right_of & depth_bit(node.depth)) != 0;
    const std::size_t lane = right ? node.direction : PackedBox<D>::kHalf + node.direction;
    const Scalar bound = right ? std::nextafter(node.plane.offset, kInfinity) : -node.plane.offset;
    cell.lane[lane] = std::max(cell.lane[lane], bound);
  }
  return cell;
}

}  // namespace

template <int D>
void LeavePass<D>::run(Tree<D>& tree, TaskPool& pool) {
  objects_.resize(tree.entries());
  stayed_.assign(tree.slots(), 0);
  leaves_.clear();
  nodes_.clear();
  std::size_t begin = 0;
  for_each_node(tree, tree.root(), [&](NodeId id) {
    nodes_.push_back(id);
    if (!tree[id].is_leaf()) return;
    leaves_.push_back({id, begin, 0});
    begin += tree[id].entries.size();
  });
  pool.for_each(leaves_.size(), [&](std::size_t k, std::size_t) {
    Leaf& leaf = leaves_[k];
    Node<D>& node = tree[leaf.id];
    const std::uint32_t axis = node.direction < D ? node.direction : 0;  // if it is none, nobody stays
    const Stayed done =
        stay_in_cell<D>({tree.table.packed().data(), cell_of(tree, leaf.id), node.right_of, axis,
                         node.entries.data(), node.entries.size(), objects_.data() + leaf.begin});
    leaf.left = done.left;
    stayed_[leaf.id.index()] = static_cast<std::uint32_t>(done.stayed);
  });
  count_ = 0;
  for (const Leaf& leaf : leaves_) {
    if (count_ < leaf.begin)
      std::copy_n(objects_.begin() + static_cast<std::ptrdiff_t>(leaf.begin), leaf.left,
                  objects_.begin() + static_cast<std::ptrdiff_t>(count_));
    count_ += leaf.left;
  }
  for (auto id = nodes_.rbegin(); id != nodes_.rend(); ++id)
    if (!tree[*id].is_leaf())
      stayed_[id->index()] = stayed_[tree[*id].left.index()] + stayed_[tree[*id].right.index()];
}

template class LeavePass<2>;
template class LeavePass<3>;

}  // namespace kerf
