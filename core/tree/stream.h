#pragma once

#include <cstdint>
#include <vector>

#include "core/tree/tree.h"

namespace kerf {

/// Memory of `stream`, kept between steps.
struct StreamBuffer {
  std::vector<std::uint32_t> objects;
  std::vector<DepthMask> straddle;
};

/// Places all objects of the table anew in one pass down the tree: each node divides the list of its objects
/// for its children. What a walk for each object costs in mispredicted branches, costs nothing here, and the
/// lists soon fit in the nearest cache. It pays when many have left their places. The structure of the tree
/// and its partitioners stay.
///
/// Pre: the tree's table has the volumes by which all are to be placed; the entries may be of any others.
template <int D>
void stream(Tree<D>& tree, StreamBuffer& buffer);

}  // namespace kerf
