#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/tree/tree.h"

namespace kerf {

/// An object stored below some node, with its straddle bits for the ancestors of that node.
struct Stored {
  ObjectId object;
  DepthMask above = 0;
};

/// Gives `object` an entry in every leaf below `from` that its volume reaches. `above` holds its straddle
/// bits for the ancestors of `from`. Returns the number of leaves.
template <int D>
std::uint32_t place(Tree<D>& tree, NodeId from, ObjectId object, DepthMask above);

/// Removes the objects from every leaf below `from`. The tree's table must still have the volumes by which
/// they were placed.
template <int D>
void displace(Tree<D>& tree, NodeId from, std::span<const ObjectId> leaving);

/// Objects that leave the tree, and the nodes that they leave: each node that an object reaches, leaves too,
/// once for that object.
struct Departure {
  std::span<const ObjectId> objects;
  std::span<const NodeId> passed;
};

/// The same if the nodes are known; an object is in one of the departures at most.
template <int D>
void displace(Tree<D>& tree, std::span<const Departure> departures, TaskPool& pool);

/// A leaf that a volume reaches, and the ancestors of the leaf that it straddles on the way.
struct Reached {
  NodeId leaf;
  DepthMask straddle = 0;
  friend constexpr bool operator==(const Reached&, const Reached&) = default;
};

/// Appends every leaf that a box reaches, left before right, and every node on the way, the leaves included.
/// For trees of boxes.
template <int D>
void reach(const Tree<D>& tree, const Box<D>& box, std::vector<Reached>& reached,
           std::vector<NodeId>& passed);

/// Whether two boxes reach the same leaves, on the same sides. Appends these leaves; if not, some of them.
/// For trees of boxes.
template <int D>
bool reach_alike(const Tree<D>& tree, const Box<D>& first, const Box<D>& second, std::vector<NodeId>& leaves);

/// Keeps a placed object in its leaves if its new volume reaches the same ones, on the same sides, as the one
/// in the tree's table: marks those leaves for the sort and returns true. Else some leaves may be marked in
/// vain, and it returns false. The entries and the table stay as they are.
template <int D>
bool try_keep_in_leaves(Tree<D>& tree, ObjectId object, const Volume<D>& new_volume);

/// Every object below `from`, each once.
template <int D>
std::vector<Stored> collect(const Tree<D>& tree, NodeId from);

}  // namespace kerf
