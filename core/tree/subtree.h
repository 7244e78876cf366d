#pragma once

#include <vector>

#include "core/tree/tree.h"

namespace kerf {

/// The direction of the ordered lists of a node's leaves: that of its partitioner, or axis 0 above the root.
template <int D>
std::uint32_t list_direction(const Tree<D>& tree, NodeId parent) {
  return parent.is_none() ? 0 : tree[parent].direction;
}

/// Projects the entries of a leaf anew on its direction; the sort phase restores their order.
template <int D>
void renew_keys(Tree<D>& tree, NodeId leaf) {
  const std::uint32_t direction = tree[leaf].direction;
  for (Entry& entry : tree[leaf].entries) entry.key = tree.project(direction, entry.object);
  tree[leaf].unsorted = true;
}

/// Ends the life of every node from `top` down.
template <int D>
void release_below(Tree<D>& tree, NodeId top) {
  std::vector<NodeId> nodes;
  for_each_node(tree, top, [&](NodeId id) { nodes.push_back(id); });
  for (const NodeId id : nodes) tree.release(id);
}

}  // namespace kerf
