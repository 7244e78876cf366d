#include "core/tree/tree_snapshot.h"

#include <algorithm>
#include <utility>

namespace kerf {

Quality TreeSnapshot::quality(NodeId id) const {
  const Node& node = (*this)[id];
  if (node.is_leaf()) return {};
  return {node.population, (*this)[node.left].population, (*this)[node.right].population};
}

void TreeSnapshot::count_leaves() {
  leaves_ = 0;
  largest_leaf_ = 0;
  for (const Node& node : nodes_) {
    if (!node.alive || !node.is_leaf()) continue;
    ++leaves_;
    largest_leaf_ = std::max(largest_leaf_, node.population);
  }
}

template <int D>
void TreeSnapshotOf<D>::assign(const Tree<D>* tree) {
  root_ = tree == nullptr ? NodeId::none() : tree->root();
  nodes_.clear();
  planes_.clear();
  if (tree != nullptr) {
    nodes_.resize(tree->slots());
    planes_.resize(tree->slots());
    for_each_node(*tree, root_, [&](NodeId id) {
      const kerf::Node<D>& node = (*tree)[id];
      nodes_[id.index()] = {node.parent, node.left,       node.right, node.generation,
                            node.depth,  node.population, true};
      planes_[id.index()] = node.plane;
    });
  }
  count_leaves();
}

template <int D>
void TreeSnapshotOf<D>::assign(NodeId root, std::vector<Node> nodes, std::vector<Plane<D>> planes) {
  root_ = root;
  nodes_ = std::move(nodes);
  planes_ = std::move(planes);
  count_leaves();
}

template class TreeSnapshotOf<2>;
template class TreeSnapshotOf<3>;

}  // namespace kerf
