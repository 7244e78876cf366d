#pragma once

#include <span>
#include <vector>

#include "core/scene/scene.h"
#include "viz/draw/clip.h"

namespace kerf {

/// A piece of ground as a plane over x and z.
struct GroundPlane {
  double height = 0;  ///< y at the point that was asked for
  double slope_x = 0;
  double slope_z = 0;
  bool is_body = false;  ///< of a fixed object; else the lower end of the bounds
};

/// What things stand on: the tops of fixed boxes, and fixed surfaces. Elsewhere the lower end of `bounds`.
class Ground {
 public:
  /// `bodies` must outlive it.
  Ground(std::span<const Body<3>> bodies, const Box<3>& bounds);

  /// The highest ground below a point.
  [[nodiscard]] GroundPlane below(const Eigen::Vector3d& point) const;

 private:
  void add(std::uint32_t body);
  [[nodiscard]] std::size_t column_of(double x, int axis) const;

  std::span<const Body<3>> bodies_;
  Box<3> bounds_;
  std::vector<std::vector<std::uint32_t>> columns_;  ///< fixed bodies by where they lie, seen from above
};

}  // namespace kerf
