#pragma once

#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/base/random.h"
#include "core/tree/tree.h"

namespace kerf::test {

/// Boxes on a small direction set, made once for each dimension.
template <int D>
std::shared_ptr<const Projector<D>> few_directions();

/// A tree of one leaf that holds object k with `boxes[k]`, after the sort phase.
template <int D>
kerf::Tree<D> tree_of(std::span<const Box<D>> boxes);

/// Renews and orders the lists that something changed, as a step does before the sweep.
template <int D>
void sort_phase(kerf::Tree<D>& tree);

/// Makes a partitioner at a leaf, good or not.
template <int D>
void plant(kerf::Tree<D>& tree, NodeId leaf, std::uint32_t direction, Scalar offset);

/// Divides random leaves by random planes, good or bad, many of them exactly at the end of some object.
template <int D>
void plant_at_random(kerf::Tree<D>& tree, std::uint32_t planes, std::uint32_t max_depth, Random& random);

/// `plant_at_random` in a tree of boxes around points of a cube of 20, with half extents up to `half`.
template <int D>
kerf::Tree<D> random_tree(Random& random, int objects, double half, std::uint32_t planes,
                          std::uint32_t max_depth);

/// The shadows of all placed objects along a direction.
template <int D>
std::vector<Interval> shadows(const kerf::Tree<D>& tree, std::uint32_t direction);

/// All inner nodes, parents first.
template <int D>
std::vector<NodeId> inner_nodes(const kerf::Tree<D>& tree);

/// The objects that have an entry somewhere below `from`, each once, in order.
template <int D>
std::vector<ObjectId> objects_below(const kerf::Tree<D>& tree, NodeId from);

/// The pairs that a sweep over all leaves gives.
template <int D>
std::vector<Pair> swept(kerf::Tree<D>& tree);

/// The pairs of the tree's boxes by definition.
template <int D>
std::vector<Pair> overlapping(const kerf::Tree<D>& tree);

}  // namespace kerf::test
