#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/base/list_room.h"
#include "core/bsp/leaf_cache.h"
#include "core/geometry/packed_box.h"
#include "core/tree/tree.h"

namespace kerf {

/// The boxes of leaves' entries, copied while objects are placed, for the sweep afterwards: they lie side by
/// side, not one here and one there in a long table. They hold until an operator changes the leaf or boxes
/// move. The memory of a leaf, and of a node that died, is kept from step to step; an inner node gives it
/// back.
template <int D>
class LeafBoxes {
 public:
  /// No leaf has any. `wanted`: they should be copied when objects are placed from now on.
  void begin(const Tree<D>& tree, bool wanted) {
    wanted_ = wanted;
    leaves_.forget();
    if (!wanted) return;
    leaves_.make_room(tree);
    for (NodeId id{0}; id.index() < tree.slots(); ++id.value)
      if (!tree[id].is_leaf()) leaves_[id] = std::vector<PackedBox<D>>();  // once the root had all boxes
  }
  [[nodiscard]] bool wanted() const { return wanted_; }
  /// Room for `count` boxes of a leaf; those that were there stay. Different leaves can be refilled at the
  /// same time.
  std::span<PackedBox<D>> refill(NodeId leaf, std::size_t count) {
    std::vector<PackedBox<D>>& boxes = leaves_[leaf];
    make_list_room(boxes, count);
    boxes.resize(count);
    return boxes;
  }
  /// Call it when the leaf's boxes are those of its entries.
  void finish(const Tree<D>& tree, NodeId leaf) { leaves_.renew(tree, leaf); }
  [[nodiscard]] bool has(const Tree<D>& tree, NodeId leaf) const { return leaves_.is_current(tree, leaf); }
  /// Exchanges the leaf's boxes for others: to lend them, and to take them back.
  void swap(NodeId leaf, std::vector<PackedBox<D>>& boxes) { std::swap(leaves_[leaf], boxes); }

 private:
  LeafCache<D, std::vector<PackedBox<D>>> leaves_;
  bool wanted_ = false;
};

}  // namespace kerf
