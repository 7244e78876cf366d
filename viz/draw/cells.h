#pragma once

#include <vector>

#include "core/tree/tree_snapshot.h"
#include "viz/draw/clip.h"

namespace kerf {

/// The sides of the ancestors on which `id` lies, from the root down: its cell, unbounded as yet.
template <int D>
std::vector<HalfSpace> cell_sides(const TreeSnapshotOf<D>& tree, NodeId id);

/// Nodes in an order in which what is drawn later never lies behind what was drawn before, seen from `eye`.
template <int D>
std::vector<NodeId> back_to_front(const TreeSnapshotOf<D>& tree, const Eigen::Vector3d& eye);

/// The partitioner `plane` within the cell of `id`: a polygon in 3D, a segment in 2D.
template <int D>
Polygon partitioner_in_cell(const TreeSnapshotOf<D>& tree, NodeId id, const Plane<D>& plane,
                            const Box<D>& bounds);
/// The same of the node's own partitioner.
template <int D>
Polygon partitioner_in_cell(const TreeSnapshotOf<D>& tree, NodeId inner, const Box<D>& bounds) {
  return partitioner_in_cell(tree, inner, tree.plane(inner), bounds);
}

/// The cell of a node within `bounds`: its faces in 3D, one polygon in 2D.
template <int D>
std::vector<Polygon> cell_faces(const TreeSnapshotOf<D>& tree, NodeId id, const Box<D>& bounds);

}  // namespace kerf
