#include "core/related/sphere_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace kerf {
namespace {

/// More than doubles round away in the few operations that make a sphere.
constexpr double kOutward = 1 + 1e-12;

template <std::size_t D>
double distance(const std::array<double, D>& a, const std::array<double, D>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < D; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

/// What the coordinates themselves may be wrong by.
template <std::size_t D>
double rounding_of(const std::array<double, D>& point) {
  double largest = std::numeric_limits<double>::min();
  for (const double x : point) largest = std::max(largest, std::abs(x));
  return 1e-14 * largest;
}

/// The next float that is not larger.
Scalar rounded_down(double x) {
  const auto nearest = static_cast<Scalar>(x);
  return double{nearest} <= x ? nearest : std::nextafter(nearest, -std::numeric_limits<Scalar>::infinity());
}

}  // namespace

template <int D>
typename SphereTree<D>::Sphere SphereTree<D>::around(const Box<D>& box) {
  Sphere sphere;
  std::array<double, D> corner{};
  for (std::size_t i = 0; i < D; ++i) {
    const auto axis = static_cast<int>(i);
    sphere.centre[i] = (double{box.min[axis]} + double{box.max[axis]}) / 2;
    corner[i] = double{box.max[axis]};
  }
  sphere.radius = distance(sphere.centre, corner) * kOutward + rounding_of(corner);
  return sphere;
}

template <int D>
typename SphereTree<D>::Sphere SphereTree<D>::around(const Sphere& a, const Sphere& b) {
  const double apart = distance(a.centre, b.centre);
  if (apart + b.radius <= a.radius) return a;
  if (apart + a.radius <= b.radius) return b;
  Sphere sphere;
  sphere.radius = (apart + a.radius + b.radius) / 2;
  const double way = apart > 0 ? (sphere.radius - a.radius) / apart : 0;
  for (std::size_t i = 0; i < D; ++i) sphere.centre[i] = a.centre[i] + way * (b.centre[i] - a.centre[i]);
  sphere.radius = sphere.radius * kOutward + rounding_of(sphere.centre);
  return sphere;
}

template <int D>
bool SphereTree<D>::meet(const Sphere& a, const Sphere& b) {
  return distance(a.centre, b.centre) <= (a.radius + b.radius) * kOutward;
}

template <int D>
std::int32_t SphereTree<D>::build(std::size_t begin, std::size_t end) {
  if (end - begin == 1) {
    nodes_.push_back(objects_[begin]);
    return static_cast<std::int32_t>(nodes_.size() - 1);
  }
  std::size_t axis = 0;
  double most = -1;
  for (std::size_t i = 0; i < D; ++i) {
    const auto [least, greatest] = std::minmax_element(
        objects_.begin() + static_cast<std::ptrdiff_t>(begin),
        objects_.begin() + static_cast<std::ptrdiff_t>(end),
        [i](const Node& a, const Node& b) { return a.sphere.centre[i] < b.sphere.centre[i]; });
    const double spread = greatest->sphere.centre[i] - least->sphere.centre[i];
    if (spread <= most) continue;
    most = spread;
    axis = i;
  }
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t k) { return objects_.begin() + static_cast<std::ptrdiff_t>(k); };
  std::nth_element(at(begin), at(middle), at(end), [axis](const Node& a, const Node& b) {
    return std::pair(a.sphere.centre[axis], a.object) < std::pair(b.sphere.centre[axis], b.object);
  });
  Node node;
  node.first = build(begin, middle);
  node.second = build(middle, end);
  node.sphere = around(nodes_[static_cast<std::size_t>(node.first)].sphere,
                       nodes_[static_cast<std::size_t>(node.second)].sphere);
  nodes_.push_back(node);
  return static_cast<std::int32_t>(nodes_.size() - 1);
}

template <int D>
void SphereTree<D>::arrange() {
  objects_.clear();
  nodes_.clear();
  for (const ObjectId object : this->placed()) {
    Node node;
    node.sphere = around(this->table().box(object));
    node.object = object;
    objects_.push_back(node);
  }
  if (!objects_.empty()) build(0, objects_.size());
}

template <int D>
template <class Visit>
void SphereTree<D>::for_each_test(const Visit& visit) const {
  if (nodes_.empty()) return;
  const auto root = static_cast<std::int32_t>(nodes_.size() - 1);
  std::vector<std::pair<std::int32_t, std::int32_t>> todo{{root, root}};
  while (!todo.empty()) {
    const auto [x, y] = todo.back();
    todo.pop_back();
    const Node& a = nodes_[static_cast<std::size_t>(x)];
    const Node& b = nodes_[static_cast<std::size_t>(y)];
    if (x == y) {
      if (a.first >= 0)
        todo.insert(todo.end(), {{a.first, a.second}, {a.second, a.second}, {a.first, a.first}});
      continue;
    }
    const bool do_meet = meet(a.sphere, b.sphere);
    visit(a, b, do_meet);
    if (!do_meet || (a.first < 0 && b.first < 0)) continue;
    const bool first = b.first < 0 || (a.first >= 0 && a.sphere.radius >= b.sphere.radius);
    if (first) todo.insert(todo.end(), {{a.second, y}, {a.first, y}});
    if (!first) todo.insert(todo.end(), {{x, b.second}, {x, b.first}});
  }
}

template <int D>
void SphereTree<D>::find_pairs(PairList& pairs) {
  candidates_ = 0;
  for_each_test([&](const Node& a, const Node& b, bool do_meet) {
    ++candidates_;
    if (!do_meet || a.first >= 0 || b.first >= 0) return;
    ++candidates_;
    if (overlaps(this->table().box(a.object), this->table().box(b.object)) &&
        !(this->table().is_fixed(a.object) && this->table().is_fixed(b.object)))
      pairs.add(make_pair(a.object, b.object));
  });
}

/// Children stand before their parents. Their boxes are part of its own, since a sphere is rounded.
template <int D>
std::vector<Box<D>> SphereTree<D>::boxes_of_nodes() const {
  std::vector<Box<D>> boxes;
  for (const Node& node : nodes_) {
    Box<D> box;
    for (int axis = 0; axis < D; ++axis) {
      const double centre = node.sphere.centre[static_cast<std::size_t>(axis)];
      box.min[axis] = rounded_down(centre - node.sphere.radius);
      box.max[axis] = -rounded_down(-centre - node.sphere.radius);
    }
    for (const std::int32_t child : {node.first, node.second})
      if (child >= 0) box = join(box, boxes[static_cast<std::size_t>(child)]);
    boxes.push_back(box);
  }
  return boxes;
}

template <int D>
void SphereTree<D>::describe(StructureParts<D>& parts) const {
  parts.kind = "tree of spheres";
  parts.is_round = true;
  const std::vector<Box<D>> boxes = boxes_of_nodes();
  const auto tell = [&](auto&& self, std::size_t index, std::uint32_t parent, std::uint32_t depth) -> void {
    const Node& node = nodes_[index];
    const auto cell = static_cast<std::uint32_t>(parts.cells.size());
    parts.cells.push_back({boxes[index], static_cast<std::uint32_t>(index), parent, depth, kNoPart});
    if (node.first < 0) return parts.members.push_back({cell, node.object});
    self(self, static_cast<std::size_t>(node.first), cell, depth + 1);
    self(self, static_cast<std::size_t>(node.second), cell, depth + 1);
  };
  if (!nodes_.empty()) tell(tell, nodes_.size() - 1, kNoPart, 0);
  for_each_test([&](const Node& a, const Node& b, bool do_meet) {
    if (do_meet && a.first < 0 && b.first < 0) parts.tell_tested(a.object, b.object);
  });
  parts.end_tested();
  parts.bytes = bytes_of(objects_) + bytes_of(nodes_);
}

template class SphereTree<2>;
template class SphereTree<3>;

}  // namespace kerf
