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

/// The share of a node's objects that may straddle its partitioner (paper section 6.1).
template <int D>
float allowed_redundancy(const Tree<D>& tree, NodeId id, const Config& config) {
  if (!config.scene_redundancy) return config.max_redundancy;
  const float allowed = config.max_redundancy * static_cast<float>(tree.objects());
  const auto population = static_cast<float>(tree[id].population);
  return allowed < population ? allowed / population : 1.0F;
}

/// The parameters as they hold at a node: a share of the scene's objects becomes one of the node's own.
template <int D>
Config config_at(const Tree<D>& tree, NodeId id, Config config) {
  config.max_redundancy = allowed_redundancy(tree, id, config);
  config.scene_redundancy = false;
  return config;
}

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

/// The share of straddlers above which a node is repaired.
template <int D>
float repair_limit(const Tree<D>& tree, NodeId id, const Config& config) {
  return std::max(config.repair_redundancy, allowed_redundancy(tree, id, config));
}

/// Whether an inner node's partitioner no longer divides: unbalanced (paper section 6.1), or straddled by
/// more than `repair_redundancy` of its objects, a case that the paper leaves open: a balanced node with
/// every object on both sides would otherwise never be repaired. What a split may accept is never repaired.
template <int D>
bool wants_repair(const Tree<D>& tree, NodeId id, const Config& config) {
  if (tree[id].is_leaf()) return false;
  const Quality q = quality(tree, id);
  return balance(q) < config.min_balance ||
         static_cast<float>(redundancy(q)) >
             repair_limit(tree, id, config) * static_cast<float>(q.population);
}

/// Whether a node that was not balanced is swapped: its heavier subtree lacks few of its objects (paper
/// section 4.5).
template <int D>
bool wants_swap(const Tree<D>& tree, NodeId id, const Config& config) {
  if (!config.swap || !wants_repair(tree, id, config)) return false;
  const Quality q = quality(tree, id);
  const auto heavy = static_cast<float>(std::max(q.left, q.right));
  return static_cast<float>(q.population) - heavy <= config.swap_share * heavy;
}

}  // namespace kerf
