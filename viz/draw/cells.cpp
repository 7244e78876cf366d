#include "viz/draw/cells.h"

#include <algorithm>
#include <utility>

namespace kerf {

template <int D>
std::vector<HalfSpace> cell_sides(const TreeSnapshotOf<D>& tree, NodeId id) {
  std::vector<HalfSpace> sides;
  for (NodeId child = id, parent; !(parent = tree[child].parent).is_none(); child = parent)
    sides.push_back(half_space(tree.plane(parent), tree[parent].right == child));
  std::ranges::reverse(sides);
  return sides;
}

template <int D>
std::vector<NodeId> back_to_front(const TreeSnapshotOf<D>& tree, const Eigen::Vector3d& eye) {
  std::vector<NodeId> order;
  if (tree.empty()) return order;
  struct Visit {
    NodeId id;
    bool children_done;
  };
  std::vector<Visit> todo{{tree.root(), false}};
  while (!todo.empty()) {
    const Visit visit = todo.back();
    todo.pop_back();
    const TreeSnapshot::Node& node = tree[visit.id];
    if (visit.children_done || node.is_leaf()) {
      order.push_back(visit.id);
      continue;
    }
    const Plane<D>& plane = tree.plane(visit.id);
    const bool eye_is_left = to_point(plane.normal).dot(eye) <= double{plane.offset};
    todo.push_back({eye_is_left ? node.left : node.right, false});
    todo.push_back({visit.id, true});
    todo.push_back({eye_is_left ? node.right : node.left, false});
  }
  return order;
}

template <int D>
Polygon partitioner_in_cell(const TreeSnapshotOf<D>& tree, NodeId id, const Plane<D>& plane,
                            const Box<D>& bounds) {
  return plane_within(half_space(plane, false), bounds, cell_sides(tree, id));
}

template <int D>
std::vector<Polygon> cell_faces(const TreeSnapshotOf<D>& tree, NodeId id, const Box<D>& bounds) {
  std::vector<HalfSpace> sides = half_spaces(bounds);
  const std::vector<HalfSpace> cell = cell_sides(tree, id);
  std::vector<Polygon> faces;
  if constexpr (D == 2) {
    const auto x0 = double{bounds.min[0]};
    const auto x1 = double{bounds.max[0]};
    const auto y0 = double{bounds.min[1]};
    const auto y1 = double{bounds.max[1]};
    Polygon polygon{{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}};
    clip(polygon, cell);
    if (!polygon.empty()) faces.push_back(std::move(polygon));
  } else {
    sides.insert(sides.end(), cell.begin(), cell.end());
    for (const HalfSpace& side : sides) {
      Polygon face = plane_within(side, bounds, cell);
      if (!face.empty()) faces.push_back(std::move(face));
    }
  }
  return faces;
}

#define KERF_INSTANTIATE(D)                                                                                  \
  template std::vector<HalfSpace> cell_sides<D>(const TreeSnapshotOf<D>&, NodeId);                           \
  template std::vector<NodeId> back_to_front<D>(const TreeSnapshotOf<D>&, const Eigen::Vector3d&);           \
  template Polygon partitioner_in_cell<D>(const TreeSnapshotOf<D>&, NodeId, const Plane<D>&, const Box<D>&); \
  template std::vector<Polygon> cell_faces<D>(const TreeSnapshotOf<D>&, NodeId, const Box<D>&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
