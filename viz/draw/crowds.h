#pragma once

#include <span>
#include <vector>

#include "core/scene/scene.h"
#include "core/tree/tree.h"

namespace kerf {

/// The space in which what belongs to a node is drawn, by node: the box around its objects with a little
/// room, within `bounds`. A plane or a cell that is drawn in all of its empty space would hide the scene. A
/// node without objects has all of `bounds`.
template <int D>
std::vector<Box<D>> find_crowds(const Tree<D>& tree, std::span<const Body<D>> bodies, const Box<D>& bounds);

/// The space of a node; `bounds` if `crowds` is empty.
template <int D>
const Box<D>& crowd_of(std::span<const Box<D>> crowds, NodeId node, const Box<D>& bounds) {
  return node.index() < crowds.size() ? crowds[node.index()] : bounds;
}

}  // namespace kerf
