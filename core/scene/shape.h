#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

#include "core/geometry/vector.h"

namespace kerf {

/// A disc in 2D, a sphere in 3D, around the body's origin.
struct Ball {
  Scalar radius = 0.5F;
  friend bool operator==(const Ball&, const Ball&) = default;
};

/// An oriented box around the body's origin; half extents along the body's own axes.
template <int D>
struct Brick {
  Vector<D> half;
  friend bool operator==(const Brick&, const Brick&) = default;
};

/// A convex outline in the body's frame, counter-clockwise (2D scenes only draw and use it).
struct Outline {
  std::vector<Vector<2>> corners;
  friend bool operator==(const Outline&, const Outline&) = default;
};

/// A triangle surface in the body's frame, shared between bodies: terrain and bucket walls.
struct Surface {
  std::vector<Vector<3>> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// The true shape of a body, as the narrow phase and the renderer see it. Two surfaces are equal if they are
/// one.
template <int D>
using Shape = std::conditional_t<D == 2, std::variant<Ball, Brick<2>, Outline>,
                                 std::variant<Ball, Brick<3>, std::shared_ptr<const Surface>>>;

/// Position and orientation of a body's frame. `axes[i]` is where the body's i-th axis points in the world.
template <int D>
struct Pose {
  Vector<D> position;
  std::array<Vector<D>, D> axes = identity_axes<D>();
};

}  // namespace kerf
