#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/geometry/box.h"
#include "core/geometry/plane.h"

namespace kerf {

/// The corners of a convex polygon in space, in order around it. Two points are a segment, none is nothing.
using Polygon = std::vector<Eigen::Vector3d>;

/// The points p with normal . p <= offset. 2D lives at z = 0.
struct HalfSpace {
  Eigen::Vector3d normal;
  double offset = 0;
};

/// The side of a partitioner: left is normal . p <= d.
template <int D>
HalfSpace half_space(const Plane<D>& plane, bool right);

/// The sides of a box: 2 * D half-spaces.
template <int D>
std::vector<HalfSpace> half_spaces(const Box<D>& box);

/// Cuts a convex polygon (or a segment) down to its part in the half-space (Sutherland and Hodgman 1974).
void clip(Polygon& polygon, const HalfSpace& side);
void clip(Polygon& polygon, std::span<const HalfSpace> sides);

/// The part of a plane within a box and the half-spaces: a polygon in 3D, a segment in 2D.
template <int D>
Polygon plane_within(const HalfSpace& plane, const Box<D>& box, std::span<const HalfSpace> sides);

/// Of a polygon that is not empty.
Eigen::Vector3d middle_of_longest_edge(const Polygon& polygon);

/// A point at z = 0 in 2D.
template <int D>
Eigen::Vector3d to_point(const Vector<D>& v) {
  return {v[0], v[1], D == 3 ? double{v[D - 1]} : 0.0};
}

}  // namespace kerf
