#pragma once

#include <algorithm>
#include <cstdint>

#include "core/base/config.h"
#include "core/tree/partitioner.h"
#include "core/tree/tree.h"

namespace kerf {

/// The split threshold t for a scene of that many objects (paper section 6.1).
std::uint32_t split_threshold(std::uint32_t objects, const Config& config);
/// Nodes with fewer objects than this are merged.
std::uint32_t merge_threshold(std::uint32_t objects, const Config& config);

/// Quality of an inner node's partitioner over the objects stored below it now. O(1).
template <int D>
Quality quality(const Tree<D>& tree, NodeId inner) {
  const Node<D>& node = tree[inner];
  return {node.population, tree[node.left].population, tree[node.right].population};
}

/// Whether Algorithm 1 splits the leaf.
template <int D>
bool wants_split(const Tree<D>& tree, NodeId id, const Config& config) {
  return config.split && tree[id].is_leaf() && tree[id].population > split_threshold(tree.objects(), config);
}

/// Whether Algorithm 1 merges the inner node.
template <int D>
bool wants_merge(const Tree<D>& tree, NodeId id, const Config& config) {
  return config.merge && !tree[id].is_leaf() && tree[id].population < merge_threshold(tree.objects(), config);
}

/// Whether an inner node's partitioner no longer divides: unbalanced (paper section 6.1), or straddled by
/// more than `repair_redundancy` of its objects, a case that the paper leaves open: a balanced node with
/// every object on both sides would otherwise never be repaired. What a split may accept is never repaired.
template <int D>
bool wants_repair(const Tree<D>& tree, NodeId id, const Config& config) {
  if (tree[id].is_leaf()) return false;
  const Quality q = quality(tree, id);
  const float accepted = std::max(config.repair_redundancy, config.max_redundancy);
  return balance(q) < config.min_balance ||
         static_cast<float>(redundancy(q)) > accepted * static_cast<float>(q.population);
}

}  // namespace kerf
