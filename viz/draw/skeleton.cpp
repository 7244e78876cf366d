#include "viz/draw/skeleton.h"

#include <algorithm>
#include <utility>

namespace kerf {

template <int D>
void Skeleton<D>::assign(const Tree<D>* tree) {
  root_ = NodeId::none();
  leaves_ = 0;
  largest_leaf_ = 0;
  joints_.clear();
  if (tree == nullptr) return;
  root_ = tree->root();
  joints_.resize(tree->slots());
  for_each_node(*tree, root_, [&](NodeId id) {
    const Node<D>& node = (*tree)[id];
    joints_[id.index()] = {node.plane,      node.parent, node.left,       node.right,
                           node.generation, node.depth,  node.population, true};
  });
  count_leaves();
}

template <int D>
void Skeleton<D>::assign(NodeId root, std::vector<Joint> joints) {
  root_ = root;
  joints_ = std::move(joints);
  count_leaves();
}

template <int D>
void Skeleton<D>::count_leaves() {
  leaves_ = 0;
  largest_leaf_ = 0;
  for (const Joint& joint : joints_) {
    if (!joint.alive || !joint.is_leaf()) continue;
    ++leaves_;
    largest_leaf_ = std::max(largest_leaf_, joint.population);
  }
}

template <int D>
bool Skeleton<D>::is_alive(NodeRef ref) const {
  return ref.node.index() < joints_.size() && joints_[ref.node.index()].alive &&
         joints_[ref.node.index()].generation == ref.generation;
}

template <int D>
std::span<const HalfSpace> Skeleton<D>::cell_sides(NodeId id) const {
  sides_.clear();
  for (NodeId child = id; !(*this)[child].parent.is_none(); child = (*this)[child].parent) {
    const Joint& parent = (*this)[(*this)[child].parent];
    sides_.push_back(half_space(parent.plane, parent.right == child));
  }
  std::ranges::reverse(sides_);
  return sides_;
}

template <int D>
std::vector<NodeId> Skeleton<D>::back_to_front(const Eigen::Vector3d& eye) const {
  std::vector<NodeId> order;
  if (empty()) return order;
  struct Visit {
    NodeId id;
    bool children_done;
  };
  std::vector<Visit> todo{{root_, false}};
  while (!todo.empty()) {
    const Visit visit = todo.back();
    todo.pop_back();
    const Joint& joint = (*this)[visit.id];
    if (visit.children_done || joint.is_leaf()) {
      order.push_back(visit.id);
      continue;
    }
    const bool eye_is_left = to_point(joint.plane.normal).dot(eye) <= double{joint.plane.offset};
    todo.push_back({eye_is_left ? joint.left : joint.right, false});
    todo.push_back({visit.id, true});
    todo.push_back({eye_is_left ? joint.right : joint.left, false});
  }
  return order;
}

template <int D>
Polygon partitioner_in_cell(const Skeleton<D>& skeleton, NodeId id, const Plane<D>& plane,
                            const Box<D>& bounds) {
  return plane_within(half_space(plane, false), bounds, skeleton.cell_sides(id));
}

template <int D>
std::vector<Polygon> cell_faces(const Skeleton<D>& skeleton, NodeId id, const Box<D>& bounds) {
  std::vector<HalfSpace> sides = half_spaces(bounds);
  const std::span<const HalfSpace> cell = skeleton.cell_sides(id);
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

#define KERF_INSTANTIATE(D)                                                                            \
  template class Skeleton<D>;                                                                          \
  template Polygon partitioner_in_cell<D>(const Skeleton<D>&, NodeId, const Plane<D>&, const Box<D>&); \
  template std::vector<Polygon> cell_faces<D>(const Skeleton<D>&, NodeId, const Box<D>&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
