#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/append_buffer.h"
#include "core/base/task_pool.h"
#include "core/bsp/leaf_boxes.h"
#include "core/tree/tree.h"

namespace kerf {

/// Finds the objects that leave their leaves when boxes have moved. Its memory is kept between steps.
template <int D>
class LeaverPass {
 public:
  /// Takes all entries out of the leaves but those of objects that straddle nothing and still lie wholly in
  /// their leaf's cell, by the boxes of the tree's table. The tree is complete again when the leavers are
  /// placed; until then populations and the number of entries are wrong. If boxes are wanted, all are copied:
  /// those of the leavers into `leaver_boxes`, the others into `boxes`.
  ///
  /// Pre: the table has boxes; all placed objects have entries, and no others do, but for those that `amend`
  /// gets. A box of NaN lies in no cell.
  void run(Tree<D>& tree, TaskPool& pool, LeafBoxes<D>& boxes);

  /// Call it before the leavers are placed, if objects came or went: those that are not placed any more are
  /// no leavers, and those that came are.
  void amend(const ObjectTable<D>& table, std::span<const ObjectId> came, bool boxes_wanted);

  /// Each object that left, once, in an order that does not depend on the number of threads.
  [[nodiscard]] std::span<const std::uint32_t> leavers() const { return leavers_.front().objects.all(); }
  /// Their boxes, in the same order; empty unless boxes were wanted.
  [[nodiscard]] std::span<const PackedBox<D>> leaver_boxes() const { return leavers_.front().boxes.all(); }
  /// How many objects stayed below each node.
  [[nodiscard]] const std::vector<std::uint32_t>& stayed() const { return stayed_; }

 private:
  struct Leavers {
    AppendBuffer<std::uint32_t> objects;
    AppendBuffer<PackedBox<D>> boxes;
  };
  std::size_t take_leavers(Tree<D>& tree, NodeId leaf, LeafBoxes<D>& boxes, Leavers& leavers) const;

  std::vector<NodeId> nodes_;
  std::vector<NodeId> leaves_;
  std::vector<Leavers> leavers_ = std::vector<Leavers>(1);  ///< by piece
  std::vector<std::uint32_t> stayed_;
};

}  // namespace kerf
