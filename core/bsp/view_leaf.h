#pragma once

#include "core/kernels/leaf_view.h"
#include "core/objects/object_table.h"
#include "core/tree/tree.h"

namespace kerf {

/// What the sweep of `leaf` reads, as the tree has it now, with boxes and mobility from `table`.
template <int D>
void view_leaf(const Tree<D>& tree, const ObjectTable<D>& table, NodeId leaf, LeafView<D>& view);
/// The same for a caller that has the boxes already: those of the view stay as they are.
template <int D>
void view_all_but_boxes(const Tree<D>& tree, const ObjectTable<D>& table, NodeId leaf, LeafView<D>& view);
/// The `apart` bits (see LeafView) of an entry of `leaf`.
template <int D>
DepthMask apart_bits(const Node<D>& leaf, DepthMask straddle, bool fixed) {
  return (straddle & leaf.right_of) | (fixed ? LeafView<D>::kFixedBit : 0);
}

}  // namespace kerf
