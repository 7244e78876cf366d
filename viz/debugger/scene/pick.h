#pragma once

#include <optional>
#include <span>

#include "core/scene/scene.h"
#include "viz/debugger/scene/ray.h"
#include "viz/draw/cells.h"

namespace kerf {

/// The object that a ray meets: in 3D the nearest, in 2D the smallest; one that moves if there is any.
template <int D>
std::optional<ObjectId> pick_object(const Ray& ray, std::span<const Body<D>> bodies);

/// What of a tree is seen and can be picked.
template <int D>
struct PickableTree {
  const TreeSnapshotOf<D>& snapshot;
  std::span<const NodeId> partitioners;   ///< those that are drawn
  std::span<const std::uint8_t> is_seen;  ///< by node
  Box<D> bounds;                          ///< all is drawn within it
};

/// The node under a pixel: the partitioner whose line is there, within a few pixels. Else in 2D the leaf; in
/// 3D the nearest of partitioners and leaves that hold something; none beside the tree.
template <int D>
std::optional<NodeId> pick_node(const PickableTree<D>& tree, const View& view, double x, double y);

}  // namespace kerf
