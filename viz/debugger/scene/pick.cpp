#include "viz/debugger/scene/pick.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "viz/draw/draw_context.h"

namespace kerf {
namespace {

constexpr double kNearLine = 5;   // pixels
constexpr double kPairReach = 4;  // pixels from its line at which a pair is found
constexpr double kDotSize = 2;    // pixels of an object that need not be met,
constexpr double kDotReach = 5;   // and those from its middle at which it is found
constexpr double kBehindAll = 1e30;
constexpr double kFar = std::numeric_limits<double>::max();

double distance_to_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d way = b - a;
  const double length = way.squaredNorm();
  const double share = length > 0 ? std::clamp((p - a).dot(way) / length, 0.0, 1.0) : 0.0;
  return (p - a - share * way).norm();
}

/// Pixels from a point of the picture to the outline of a polygon, or to a segment.
double distance_to_outline(const View& view, const Polygon& polygon, const Eigen::Vector2d& pixel) {
  double nearest = kFar;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const auto a = view.project(polygon[k]);
    const auto b = view.project(polygon[(k + 1) % polygon.size()]);
    if (a && b) nearest = std::min(nearest, distance_to_segment(pixel, *a, *b));
  }
  return nearest;
}

/// The partitioner with a line there; among equally near ones the higher, which is drawn thicker.
template <int D>
std::optional<NodeId> line_at(const PickableTree<D>& tree, const View& view, const Eigen::Vector2d& pixel) {
  std::optional<NodeId> best;
  double nearest = kNearLine * tree.scale;
  for (const NodeId id : tree.partitioners) {
    const TreeSnapshot::Node& node = tree.snapshot[id];
    const Polygon polygon = partitioner_in_cell(tree.snapshot, id, crowd_of(tree.crowds, id, tree.bounds));
    const double distance = distance_to_outline(view, polygon, pixel);
    constexpr double kSame = 0.5;  // of two lines in one place
    const bool higher = best && node.depth < tree.snapshot[*best].depth;
    if (distance >= nearest + (higher ? kSame : best ? -kSame : 0)) continue;
    nearest = distance;
    best = id;
  }
  return best;
}

template <int D>
std::vector<HalfSpace> sides_of(const PickableTree<D>& tree, NodeId id) {
  std::vector<HalfSpace> sides = half_spaces(crowd_of(tree.crowds, id, tree.bounds));
  const auto cell = cell_sides(tree.snapshot, id);
  sides.insert(sides.end(), cell.begin(), cell.end());
  return sides;
}

/// The distance to the partitioner within its cell, in multiples of `way`.
template <int D>
std::optional<double> distance_to_pane(const PickableTree<D>& tree, NodeId id, const SightRay& ray) {
  const HalfSpace plane = half_space(tree.snapshot.plane(id), false);
  const double speed = plane.normal.dot(ray.way);
  if (std::abs(speed) < 1e-300) return std::nullopt;
  const double there = (plane.offset - plane.normal.dot(ray.start)) / speed;
  const SightRay point{ray.start + there * ray.way, Eigen::Vector3d::Zero()};
  return there > 0 && distance_to(point, sides_of(tree, id)) ? std::optional(there) : std::nullopt;
}

/// The object nearest to a pixel among those that are hardly larger than one: a point is met by no ray.
template <int D>
std::optional<ObjectId> dot_at(std::span<const Body<D>> bodies, const View& view,
                               const Eigen::Vector2d& pixel, double scale) {
  std::optional<ObjectId> best;
  double nearest = kDotReach * scale;
  for (std::uint32_t id = 0; id < bodies.size(); ++id) {
    if (!is_drawable(bodies[id])) continue;
    const Vector<D> extent = bodies[id].box.extent();
    const Eigen::Vector3d middle = to_point(bodies[id].box.center());
    const double size = *std::ranges::max_element(extent.value) * view.pixels_per_unit(middle);
    const auto seen = view.project(middle);
    if (!seen || size > kDotSize * scale || (pixel - *seen).norm() > nearest) continue;
    nearest = (pixel - *seen).norm();
    best = ObjectId{id};
  }
  return best;
}

}  // namespace

template <int D>
std::optional<ObjectId> pick_object(std::span<const Body<D>> bodies, const View& view,
                                    const Eigen::Vector2d& pixel, double scale) {
  const SightRay ray = ray_through(view, pixel.x(), pixel.y());
  std::optional<ObjectId> best;
  double nearest = kFar;
  for (std::uint32_t id = 0; id < bodies.size(); ++id) {
    if (!is_drawable(bodies[id])) continue;
    const Box<D>& box = bodies[id].box;
    const auto hit = distance_to(ray, box);
    if (!hit) continue;
    double rank = D == 3 ? *hit : double{box.extent()[0]} * double{box.extent()[1]};
    if (bodies[id].mobility == Mobility::fixed)
      rank += kBehindAll;  // ground and walls do not hide what is behind them
    if (rank >= nearest) continue;
    nearest = rank;
    best = ObjectId{id};
  }
  if (D == 3 && best && bodies[best->index()].mobility == Mobility::moving) return best;
  const auto dot = dot_at(bodies, view, pixel, scale);
  return dot ? dot : best;
}

template <int D>
std::optional<NodeId> pick_node(const PickableTree<D>& tree, const View& view, double x, double y) {
  if (const auto line = line_at(tree, view, {x, y})) return line;
  const SightRay ray = ray_through(view, x, y);
  std::optional<NodeId> best;
  double nearest = kFar;
  const auto take = [&](NodeId id, const std::optional<double>& distance) {
    if (!distance || *distance >= nearest) return;
    nearest = *distance;
    best = id;
  };
  if constexpr (D == 3)
    for (const NodeId id : tree.partitioners) take(id, distance_to_pane(tree, id, ray));
  for (std::uint32_t k = 0; k < tree.is_seen.size(); ++k) {
    const NodeId id{k};
    const TreeSnapshot::Node& node = tree.snapshot[id];
    if (tree.is_seen[k] == 0 || !node.is_leaf() || (D == 3 && node.population == 0)) continue;
    take(id, distance_to(ray, sides_of(tree, id)));
  }
  return best;
}

template <int D>
std::optional<Pair> pick_pair(std::span<const Pair> pairs, std::span<const Body<D>> bodies, const View& view,
                              const Eigen::Vector2d& pixel, double scale) {
  std::optional<Pair> nearest;
  double least = kPairReach * scale;
  for (const Pair& pair : pairs) {
    const auto [a, b] = pair_line<D>(view, bodies[pair.a.index()], bodies[pair.b.index()]);
    const auto from = view.project(a);
    const auto to = view.project(b);
    if (!from || !to) continue;
    const double away = distance_to_segment(pixel, *from, *to);
    if (away < least) nearest = pair;
    least = std::min(least, away);
  }
  return nearest;
}

template std::optional<Pair> pick_pair<2>(std::span<const Pair>, std::span<const Body<2>>, const View&,
                                          const Eigen::Vector2d&, double);
template std::optional<Pair> pick_pair<3>(std::span<const Pair>, std::span<const Body<3>>, const View&,
                                          const Eigen::Vector2d&, double);
template std::optional<ObjectId> pick_object<2>(std::span<const Body<2>>, const View&, const Eigen::Vector2d&,
                                                double);
template std::optional<ObjectId> pick_object<3>(std::span<const Body<3>>, const View&, const Eigen::Vector2d&,
                                                double);
template std::optional<NodeId> pick_node<2>(const PickableTree<2>&, const View&, double, double);
template std::optional<NodeId> pick_node<3>(const PickableTree<3>&, const View&, double, double);

}  // namespace kerf
