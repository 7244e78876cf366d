#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/tree/tree.h"

namespace kerf {

/// An object that leaves its place, with the box by which it was placed.
template <int D>
struct Leaving {
  ObjectId object;
  Box<D> box;
};

/// An object stored below some node, with its straddle bits for the ancestors of that node.
struct Stored {
  ObjectId object;
  DepthMask above = 0;
};

/// Gives `object` an entry in every leaf below `from` that its box reaches. `above` holds its straddle bits
/// for the ancestors of `from`. Returns the number of leaves.
template <int D>
std::uint32_t place(Tree<D>& tree, NodeId from, ObjectId object, DepthMask above);

/// Takes the objects out of every leaf below `from` that their old boxes reach.
template <int D>
void displace(Tree<D>& tree, NodeId from, std::span<const Leaving<D>> leaving);

/// True if the object's new box reaches the same leaves, on the same sides, as the old one did; those leaves
/// are then marked for the sort. When false, the entries are as they were.
template <int D>
bool stays(Tree<D>& tree, const Box<D>& old_box, const Box<D>& new_box);

/// Every object below `from`, each once.
template <int D>
std::vector<Stored> collect(const Tree<D>& tree, NodeId from);

}  // namespace kerf
