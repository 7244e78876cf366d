#include "viz/draw/icicle.h"

#include <algorithm>

namespace kerf {
namespace {

/// What a node's width is taken from.
double weight_of(const TreeSnapshot& tree, NodeId id) { return std::max(1U, tree[id].population); }

}  // namespace

std::vector<IcicleBar> icicle_bars(const TreeSnapshot& tree) {
  std::vector<IcicleBar> bars;
  if (tree.empty()) return bars;
  std::vector<IcicleBar> todo{{tree.root(), 0, 0, 1}};
  while (!todo.empty()) {
    const IcicleBar bar = todo.back();
    todo.pop_back();
    bars.push_back(bar);
    const TreeSnapshot::Node& node = tree[bar.node];
    if (node.is_leaf()) continue;
    const double left = weight_of(tree, node.left);
    const double share = left / (left + weight_of(tree, node.right));
    const double middle = bar.left + share * (bar.right - bar.left);
    todo.push_back({node.right, bar.depth + 1, middle, bar.right});
    todo.push_back({node.left, bar.depth + 1, bar.left, middle});
  }
  return bars;
}

}  // namespace kerf
