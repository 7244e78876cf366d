#include "viz/draw/clip.h"

#include <Eigen/Geometry>
#include <cmath>

namespace kerf {
namespace {

/// How far p lies outside of the half-space, in units of the normal's length. A distance within rounding
/// counts as on the border, so that a polygon is not cut away by the plane that it lies in.
double above(const HalfSpace& side, const Eigen::Vector3d& p) {
  constexpr double kRounding = 1e-11;
  const Eigen::Vector3d terms = side.normal.cwiseProduct(p);
  const double height = terms.sum() - side.offset;
  return std::abs(height) <= kRounding * (terms.cwiseAbs().sum() + std::abs(side.offset)) ? 0 : height;
}

/// A piece of the plane that reaches farther than any point of the box.
template <int D>
Polygon large_piece(const HalfSpace& plane, const Box<D>& box) {
  const Eigen::Vector3d low = to_point(box.min);
  const Eigen::Vector3d high = to_point(box.max);
  const Eigen::Vector3d center = 0.5 * (low + high);
  const double reach = (high - low).norm() + 1e-9;
  const double square = plane.normal.squaredNorm();
  const Eigen::Vector3d foot = center - plane.normal * (above(plane, center) / square);
  if constexpr (D == 2) {
    const Eigen::Vector3d along(-plane.normal.y(), plane.normal.x(), 0);
    const Eigen::Vector3d arm = along * (reach / std::sqrt(square));
    return {foot - arm, foot + arm};
  } else {
    const Eigen::Vector3d u = plane.normal.unitOrthogonal() * reach;
    const Eigen::Vector3d v = plane.normal.normalized().cross(u);
    return {foot - u - v, foot + u - v, foot + u + v, foot - u + v};
  }
}

}  // namespace

template <int D>
HalfSpace half_space(const Plane<D>& plane, bool right) {
  const double sign = right ? -1 : 1;
  return {sign * to_point(plane.normal), sign * double{plane.offset}};
}

template <int D>
std::vector<HalfSpace> half_spaces(const Box<D>& box) {
  std::vector<HalfSpace> sides;
  for (int axis = 0; axis < D; ++axis) {
    const Eigen::Vector3d unit = Eigen::Vector3d::Unit(axis);
    sides.push_back({unit, box.max[axis]});
    sides.push_back({-unit, -double{box.min[axis]}});
  }
  return sides;
}

void clip(Polygon& polygon, const HalfSpace& side) {
  thread_local Polygon kept;
  kept.clear();
  const std::size_t count = polygon.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d& p = polygon[i];
    const double height = above(side, p);
    if (height <= 0) kept.push_back(p);
    if (count == 2 && i == 1) break;  // a segment has no edge back to its start
    const Eigen::Vector3d& q = polygon[(i + 1) % count];
    const double next = above(side, q);
    if ((height < 0 && next > 0) || (height > 0 && next < 0))
      kept.push_back(p + (q - p) * (height / (height - next)));
  }
  polygon.swap(kept);
  const std::size_t least = count == 2 ? 2 : 3;
  if (polygon.size() < least) polygon.clear();
}

void clip(Polygon& polygon, std::span<const HalfSpace> sides) {
  for (const HalfSpace& side : sides) {
    if (polygon.empty()) return;
    clip(polygon, side);
  }
}

template <int D>
Polygon plane_within(const HalfSpace& plane, const Box<D>& box, std::span<const HalfSpace> sides) {
  if (!(plane.normal.squaredNorm() > 0)) return {};
  Polygon polygon = large_piece(plane, box);
  clip(polygon, half_spaces(box));
  clip(polygon, sides);
  return polygon;
}

Eigen::Vector3d middle_of_longest_edge(const Polygon& polygon) {
  Eigen::Vector3d longest = Eigen::Vector3d::Zero();
  Eigen::Vector3d middle = polygon.front();
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Eigen::Vector3d edge = polygon[(k + 1) % polygon.size()] - polygon[k];
    if (edge.squaredNorm() <= longest.squaredNorm()) continue;
    longest = edge;
    middle = polygon[k] + 0.5 * edge;
  }
  return middle;
}

#define KERF_INSTANTIATE(D)                                   \
  template HalfSpace half_space<D>(const Plane<D>&, bool);    \
  template std::vector<HalfSpace> half_spaces(const Box<D>&); \
  template Polygon plane_within(const HalfSpace&, const Box<D>&, std::span<const HalfSpace>);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
