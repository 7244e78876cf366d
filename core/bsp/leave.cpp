#include "core/bsp/leave.h"

#include <algorithm>
#include <utility>

#include "core/kernels/stay_in_cell.h"
#include "core/tree/cell.h"

namespace kerf {

/// Returns the number of objects that stay.
template <int D>
std::size_t LeaverPass<D>::take_leavers(Tree<D>& tree, NodeId leaf, LeafBoxes<D>& boxes,
                                        Leavers& leavers) const {
  Node<D>& node = tree[leaf];
  const std::size_t count = node.entries.size();
  const Stayed done = stay_in_cell<D>({
      .boxes = std::as_const(tree.table).packed().data(),
      .cell = cell_of(tree, leaf),
      .right_of = node.right_of,
      .axis = node.direction < D ? node.direction : 0,  // no object stays in a leaf that has none
      .entries = node.entries.data(),
      .count = count,
      .leavers = leavers.objects.reserve(count),
      .leaver_boxes = boxes.wanted() ? leavers.boxes.reserve(count) : nullptr,
      .stayer_boxes = boxes.wanted() ? boxes.refill(leaf, count).data() : nullptr,
  });
  leavers.objects.commit(done.left);
  if (boxes.wanted()) leavers.boxes.commit(done.left);
  return done.stayed;
}

template <int D>
void LeaverPass<D>::run(Tree<D>& tree, TaskPool& pool, LeafBoxes<D>& boxes) {
  stayed_.assign(tree.slots(), 0);
  leaves_.clear();
  nodes_.clear();
  for_each_node(tree, tree.root(), [&](NodeId id) {
    nodes_.push_back(id);
    if (tree[id].is_leaf()) leaves_.push_back(id);
  });
  leavers_.resize(std::max(leavers_.size(), pool.pieces()));
  for (Leavers& leavers : leavers_) {
    leavers.objects.clear();
    leavers.boxes.clear();
  }
  pool.for_each(pool.pieces(), [&](std::size_t piece, std::size_t) {
    const Slice leaves = slice(leaves_.size(), pool.pieces(), piece);
    for (std::size_t k = leaves.begin; k < leaves.end; ++k)
      stayed_[leaves_[k].index()] =
          static_cast<std::uint32_t>(take_leavers(tree, leaves_[k], boxes, leavers_[piece]));
  });
  for (std::size_t piece = 1; piece < leavers_.size(); ++piece) {
    leavers_.front().objects.append(std::as_const(leavers_[piece].objects).all());
    leavers_.front().boxes.append(std::as_const(leavers_[piece].boxes).all());
  }
  for (auto id = nodes_.rbegin(); id != nodes_.rend(); ++id)
    if (!tree[*id].is_leaf())
      stayed_[id->index()] = stayed_[tree[*id].left.index()] + stayed_[tree[*id].right.index()];
}

template <int D>
void LeaverPass<D>::amend(const ObjectTable<D>& table, std::span<const ObjectId> came, bool boxes_wanted) {
  auto& [objects, boxes] = leavers_.front();
  std::size_t left = 0;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    const std::uint32_t object = objects.all()[k];
    if (!table.is_placed({object})) continue;
    objects.all()[left] = object;
    if (boxes_wanted) boxes.all()[left] = boxes.all()[k];
    ++left;
  }
  objects.truncate(left);
  if (boxes_wanted) boxes.truncate(left);
  for (const ObjectId object : came) {
    objects.push_back(object.value);
    if (boxes_wanted) boxes.push_back(table.packed(object));
  }
}

template class LeaverPass<2>;
template class LeaverPass<3>;

}  // namespace kerf
