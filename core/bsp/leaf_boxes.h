#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/base/list_room.h"
#include "core/geometry/packed_box.h"
#include "core/tree/tree.h"

namespace kerf {

/// The boxes of leaves' entries, copied while objects are placed, for who goes through a leaf afterwards:
/// they lie side by side, not one here and one there in a long table. They hold until an operator changes the
/// leaf or boxes move. Leaves keep their memory from step to step, and nodes that died theirs.
template <int D>
class LeafBoxes {
 public:
  /// No leaf has any. `wanted`: who places objects from now on should copy them.
  void begin(const Tree<D>& tree, bool wanted) {
    wanted_ = wanted;
    for (Leaf& leaf : leaves_) leaf.life = 0;
    if (wanted && leaves_.size() < tree.slots()) leaves_.resize(tree.slots());
  }
  [[nodiscard]] bool wanted() const { return wanted_; }
  /// Room for `count` boxes of a leaf; those that were there stay. Different leaves can be refilled at the
  /// same time.
  std::span<PackedBox<D>> refill(NodeId leaf, std::size_t count) {
    std::vector<PackedBox<D>>& boxes = leaves_[leaf.index()].boxes;
    make_list_room(boxes, count);
    boxes.resize(count);
    return boxes;
  }
  /// To be told when the leaf's boxes are those of its entries.
  void finish(Tree<D>& tree, NodeId leaf) {
    leaves_[leaf.index()].life = tree[leaf].generation + 1;
    tree[leaf].changed = false;
  }
  [[nodiscard]] bool has(const Tree<D>& tree, NodeId leaf) const {
    return leaf.index() < leaves_.size() && leaves_[leaf.index()].life == tree[leaf].generation + 1 &&
           !tree[leaf].changed;
  }
  /// Exchanges the leaf's boxes for others: to lend them, and to take them back.
  void swap(NodeId leaf, std::vector<PackedBox<D>>& boxes) { std::swap(leaves_[leaf.index()].boxes, boxes); }

 private:
  struct Leaf {
    std::uint32_t life = 0;  ///< one more than the generation of the node; 0: there are no boxes
    std::vector<PackedBox<D>> boxes;
  };
  std::vector<Leaf> leaves_;  ///< by node
  bool wanted_ = false;
};

}  // namespace kerf
