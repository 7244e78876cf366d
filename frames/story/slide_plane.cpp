#include "frames/story/slide_plane.h"

#include <algorithm>

#include "viz/draw/cells.h"

namespace kerf {
namespace {

/// Smooth, with a rest at either end, for the eye to find the plane.
double eased(double progress) {
  const double t = std::clamp((progress - 0.2) / 0.5, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

void shrink(Polygon& polygon, double part) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& corner : polygon) middle += corner / static_cast<double>(polygon.size());
  for (Eigen::Vector3d& corner : polygon) corner = middle + part * (corner - middle);
}

/// Only if the node still has the plane that the operator gave it.
template <int D>
void move_plane(FramePlan<D>& plan, Highlight& highlight, double part) {
  const NodeId node = highlight.acted.node.node;
  TreeSnapshotOf<D>& tree = plan.snapshot;
  if (!tree.is_alive(highlight.acted.node) || tree[node].is_leaf()) return;
  std::vector<Plane<D>> planes(tree.planes().begin(), tree.planes().end());
  Plane<D>& plane = planes[node.index()];
  if (plane.offset != highlight.acted.new_offset) return;
  plane.offset = static_cast<Scalar>(highlight.acted.old_offset +
                                     part * (highlight.acted.new_offset - highlight.acted.old_offset));
  highlight.partitioner = partitioner_in_cell(tree, node, plane, crowd_of<D>(plan.crowds, node, plan.bounds));
  tree.assign(tree.root(), {tree.nodes().begin(), tree.nodes().end()}, std::move(planes));
}

}  // namespace

template <int D>
void slide_plane(FramePlan<D>& plan, const StoryMoment& moment, double progress) {
  const double part = eased(progress);
  for (Highlight& highlight : plan.highlights) {
    if (highlight.event != moment.event) continue;
    if (moment.acted.op == Operator::balance)
      move_plane(plan, highlight, part);
    else if (moment.acted.op == Operator::split || moment.acted.op == Operator::shift_split)
      shrink(highlight.partitioner, part);
    else
      shrink(highlight.old_partitioner, 1 - part);
  }
}

template void slide_plane(FramePlan<2>&, const StoryMoment&, double);
template void slide_plane(FramePlan<3>&, const StoryMoment&, double);

}  // namespace kerf
