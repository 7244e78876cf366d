#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "core/geometry/box.h"
#include "viz/draw/camera.h"
#include "viz/draw/clip.h"

namespace kerf {

/// The ray through a pixel: from `start` on along `way`, in scene units.
struct SightRay {
  Eigen::Vector3d start;
  Eigen::Vector3d way;
};

SightRay ray_through(const View& view, double x, double y);

/// The distance to the box in multiples of `way`; none if the ray misses it. In 2D 0 for a box around the
/// point.
template <int D>
std::optional<double> distance_to(const SightRay& ray, const Box<D>& box);

/// The same for the intersection of half-spaces; 0 from within it.
std::optional<double> distance_to(const SightRay& ray, std::span<const HalfSpace> sides);

}  // namespace kerf
