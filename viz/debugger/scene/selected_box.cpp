#include "viz/debugger/scene/selected_box.h"

#include <algorithm>

#include "viz/draw/cells.h"

namespace kerf {
namespace {

template <int D>
void stretch(Box<D>& box, const Vector<D>& min, const Vector<D>& max) {
  for (int axis = 0; axis < D; ++axis) {
    box.min[axis] = std::min(box.min[axis], min[axis]);
    box.max[axis] = std::max(box.max[axis], max[axis]);
  }
}

template <int D>
std::optional<Box<D>> box_of_object(ObjectId object, const ObjectTable<D>& objects) {
  return objects.is_placed(object) ? std::optional(objects.box(object)) : std::nullopt;
}

template <int D>
std::optional<Box<D>> box_of_pair(const Pair& pair, const ObjectTable<D>& objects) {
  auto a = box_of_object(pair.a, objects);
  const auto b = box_of_object(pair.b, objects);
  if (!a || !b) return a ? a : b;
  stretch(*a, b->min, b->max);
  return a;
}

template <int D>
std::optional<Box<D>> box_of_node(NodeId node, const Surroundings<D>& scene) {
  if (!scene.tree.is_alive(node)) return std::nullopt;
  Box<D> box{scene.bounds.max, scene.bounds.min};
  for (const Polygon& face : cell_faces(scene.tree, node, scene.bounds))
    for (const Eigen::Vector3d& corner : face) {
      Vector<D> point;
      for (int axis = 0; axis < D; ++axis) point[axis] = static_cast<Scalar>(corner[axis]);
      stretch(box, point, point);
    }
  return box;
}

}  // namespace

template <int D>
std::optional<Box<D>> box_of(const Selection& selection, const Surroundings<D>& scene) {
  return std::visit(Overloaded{
                        [](std::monostate) { return std::optional<Box<D>>(); },
                        [&](NodeId node) { return box_of_node(node, scene); },
                        [&](ObjectId object) { return box_of_object(object, scene.objects); },
                        [&](const Pair& pair) { return box_of_pair(pair, scene.objects); },
                    },
                    selection);
}

template std::optional<Box<2>> box_of<2>(const Selection&, const Surroundings<2>&);
template std::optional<Box<3>> box_of<3>(const Selection&, const Surroundings<3>&);

}  // namespace kerf
