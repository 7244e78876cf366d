#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "core/geometry/box.h"
#include "viz/draw/camera.h"
#include "viz/draw/clip.h"

namespace kerf {

/// What lies under a pixel: from `start` on along `way`, in scene units.
struct Ray {
  Eigen::Vector3d start;
  Eigen::Vector3d way;
};

Ray ray_through(const View& view, double x, double y);

/// How many times `way` it is to the box; none if the ray misses it. In 2D 0 for a box around the point.
template <int D>
std::optional<double> distance_to(const Ray& ray, const Box<D>& box);

/// The same for the part of space that half-spaces leave; 0 from within it.
std::optional<double> distance_to(const Ray& ray, std::span<const HalfSpace> sides);

}  // namespace kerf
