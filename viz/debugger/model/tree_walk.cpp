#include "viz/debugger/model/tree_walk.h"

namespace kerf {

std::optional<NodeId> neighbour_of(const TreeSnapshot& tree, std::optional<NodeId> from, TreeWay way) {
  if (tree.empty()) return std::nullopt;
  if (!from || !tree.is_alive(*from)) return tree.root();
  const TreeSnapshot::Node& node = tree[*from];
  if (way == TreeWay::left || way == TreeWay::right) {
    if (node.is_leaf()) return from;
    return way == TreeWay::left ? node.left : node.right;
  }
  if (node.parent.is_none()) return from;
  if (way == TreeWay::up) return node.parent;
  const TreeSnapshot::Node& parent = tree[node.parent];
  return parent.left == *from ? parent.right : parent.left;
}

}  // namespace kerf
