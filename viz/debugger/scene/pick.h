#pragma once

#include <optional>
#include <span>

#include "core/scene/scene.h"
#include "viz/debugger/scene/ray.h"
#include "viz/draw/cells.h"
#include "viz/draw/crowds.h"

namespace kerf {

/// The object at a pixel: in 3D the nearest, in 2D the smallest; a moving one if there is any. One that is
/// hardly larger than a pixel counts within a few pixels, more on a fine display: `scale`; in 3D where no
/// other moves.
template <int D>
std::optional<ObjectId> pick_object(std::span<const Body<D>> bodies, const View& view,
                                    const Eigen::Vector2d& pixel, double scale = 1);

/// The pair whose line, as `draw_pairs` draws it, is nearest to a pixel and within a few of it, more on a
/// fine display: `scale`.
template <int D>
std::optional<Pair> pick_pair(std::span<const Pair> pairs, std::span<const Body<D>> bodies, const View& view,
                              const Eigen::Vector2d& pixel, double scale = 1);

/// The visible part of a tree, for picking.
template <int D>
struct PickableTree {
  const TreeSnapshotOf<D>& snapshot;
  std::span<const NodeId> partitioners;   ///< those drawn
  std::span<const std::uint8_t> is_seen;  ///< by node
  Box<D> bounds;                          ///< the limits of the drawing
  double scale = 1;                       ///< pixels of the display for each of those that count here
  std::span<const Box<D>> crowds{};       ///< by node: the limits of its plane, see `find_crowds`
};

/// The node under a pixel: the partitioner whose line is there, within a few pixels. Else in 2D the leaf; in
/// 3D the nearest partitioner or non-empty leaf; none beside the tree.
template <int D>
std::optional<NodeId> pick_node(const PickableTree<D>& tree, const View& view, double x, double y);

}  // namespace kerf
