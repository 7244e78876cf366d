#pragma once

#include <cstdint>
#include <optional>

#include "core/tree/tree_snapshot.h"

namespace kerf {

/// A way from a node to a neighbour in the tree.
enum class TreeWay : std::uint8_t { up, left, right, across };

/// The parent, the left or right child, or the other child of the parent; the node itself if it has none. The
/// root if there is no living node to start from; none in an empty tree.
std::optional<NodeId> neighbour_of(const TreeSnapshot& tree, std::optional<NodeId> from, TreeWay way);

}  // namespace kerf
