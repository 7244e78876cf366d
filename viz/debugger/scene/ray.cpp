#include "viz/debugger/scene/ray.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace kerf {

SightRay ray_through(const View& view, double x, double y) {
  const double right = 2 * x / view.picture_width - 1;
  const double down = 2 * y / view.picture_height - 1;
  if (!view.perspective) {
    // 2D: x and y of the picture depend on x and y of the scene only.
    const Eigen::Matrix2d m = view.clip_from_world.topLeftCorner<2, 2>();
    const Eigen::Vector2d p =
        m.inverse() * (Eigen::Vector2d(right, down) - view.clip_from_world.topRightCorner<2, 1>());
    return {{p.x(), p.y(), 0}, Eigen::Vector3d::Zero()};
  }
  const Eigen::Vector4d far = view.clip_from_world.inverse() * Eigen::Vector4d(right, down, 1, 1);
  return {view.eye, far.head<3>() / far.w() - view.eye};
}

template <int D>
std::optional<double> distance_to(const SightRay& ray, const Box<D>& box) {
  double enter = 0;
  double leave = std::numeric_limits<double>::max();
  for (int axis = 0; axis < D; ++axis) {
    const double low = double{box.min[axis]} - ray.start[axis];
    const double high = double{box.max[axis]} - ray.start[axis];
    if (std::abs(ray.way[axis]) < 1e-300) {
      if (low > 0 || high < 0) return std::nullopt;
      continue;
    }
    const double a = low / ray.way[axis];
    const double b = high / ray.way[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave ? std::optional(enter) : std::nullopt;
}

std::optional<double> distance_to(const SightRay& ray, std::span<const HalfSpace> sides) {
  double enter = 0;
  double leave = std::numeric_limits<double>::max();
  for (const HalfSpace& side : sides) {
    const double speed = side.normal.dot(ray.way);
    const double room = side.offset - side.normal.dot(ray.start);
    if (std::abs(speed) < 1e-300) {
      constexpr double kTouch = 1e-6;  // corners have rounding errors
      if (room < -kTouch) return std::nullopt;
    } else if (speed > 0) {
      leave = std::min(leave, room / speed);
    } else {
      enter = std::max(enter, room / speed);
    }
  }
  return enter <= leave ? std::optional(enter) : std::nullopt;
}

template std::optional<double> distance_to<2>(const SightRay&, const Box<2>&);
template std::optional<double> distance_to<3>(const SightRay&, const Box<3>&);

}  // namespace kerf
