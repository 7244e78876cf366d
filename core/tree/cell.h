#pragma once

#include "core/geometry/packed_box.h"
#include "core/tree/tree.h"

namespace kerf {

/// The boxes that `classify` sends to this leaf and to no other, as a packed box around them. Partitioners
/// along no axis are not represented: beside one, the cell holds nothing. Beside a partitioner through zero a
/// cell may leave out boxes that begin at a denormal.
template <int D>
PackedBox<D> cell_of(const Tree<D>& tree, NodeId leaf);

}  // namespace kerf
