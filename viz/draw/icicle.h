#pragma once

#include <cstdint>
#include <vector>

#include "core/tree/tree_snapshot.h"

namespace kerf {

/// A node in an icicle, in which the root spans the whole width and children lie below their parent.
struct IcicleBar {
  NodeId node;
  std::uint32_t depth = 0;
  double left = 0;  ///< from 0 to 1, as `right`
  double right = 1;
};

/// The nodes in the order of a walk from the root, left children first. Children share the width of their
/// parent as they share its population, an empty one as if it had one object. Empty for an empty tree.
std::vector<IcicleBar> icicle_bars(const TreeSnapshot& tree);

}  // namespace kerf
