#include "viz/debugger/scene/orbit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "viz/draw/clip.h"

namespace kerf {
namespace {

constexpr double kDegreesPerPixel = 0.4;
constexpr double kZoomPerClick = 0.85;

}  // namespace

/// A flat view has no part without text that would be worth it.
template <int D>
Viewport Orbit<D>::framed(int width, int height) const {
  constexpr double kMost = 0.4;
  const double share = std::min(1.0, kMost * height / std::max(1e-9, above_ + below_));
  return {0, share * above_, static_cast<double>(width), height - share * (above_ + below_)};
}

template <int D>
View Orbit<D>::view(int width, int height) const {
  return kerf::frame_all(box_, choice_, framed(width, height), width, height);
}

/// Replaces the automatic choices of the camera by numbers, which the mouse can change.
template <int D>
void Orbit<D>::settle(int width, int height) {
  const View now = view(width, height);
  if constexpr (D == 3) {
    if (choice_.target && choice_.distance) return;
    if (!choice_.target) choice_.target = to_point(box_.center());
    choice_.distance = std::max(1e-3, now.forward.dot(*choice_.target - now.eye));
    choice_.target = now.eye + now.forward * *choice_.distance;
  } else {
    if (!choice_.center) choice_.center = to_point(box_.center()).template head<2>();
    choice_.width = choice_.width.value_or(width / now.pixels_per_unit_at_one);
  }
}

template <int D>
void Orbit<D>::turn(double dx, double dy, int width, int height) {
  if constexpr (D == 3) {
    settle(width, height);
    choice_.yaw -= dx * kDegreesPerPixel;
    choice_.pitch = std::clamp(choice_.pitch + dy * kDegreesPerPixel, -89.0, 89.9);
  } else {
    move(dx, dy, width, height);
  }
}

template <int D>
void Orbit<D>::move(double dx, double dy, int width, int height) {
  settle(width, height);
  const View now = view(width, height);
  if constexpr (D == 3) {
    const double unit = *choice_.distance / now.pixels_per_unit_at_one;
    const double yaw = choice_.yaw * std::numbers::pi / 180;
    const Eigen::Vector3d right(std::cos(yaw), 0, -std::sin(yaw));
    *choice_.target += unit * (dy * right.cross(now.forward) - dx * right);
  } else {
    *choice_.center += Eigen::Vector2d(-dx, dy) / now.pixels_per_unit_at_one;
  }
}

template <int D>
void Orbit<D>::zoom(double clicks, double x, double y, int width, int height) {
  settle(width, height);
  const double factor = std::pow(kZoomPerClick, clicks);
  if constexpr (D == 3) {
    *choice_.distance = std::clamp(*choice_.distance * factor, 1e-3, 1e9);
  } else {
    const Viewport seen = framed(width, height);
    const Eigen::Vector2d offset(x - 0.5 * width, seen.top + 0.5 * seen.height - y);
    *choice_.center += (1 - factor) / view(width, height).pixels_per_unit_at_one * offset;
    choice_.width = std::clamp(*choice_.width * factor, 1e-6, 1e12);
  }
}

template <int D>
void Orbit<D>::look_at(const Box<D>& box, int width, int height) {
  settle(width, height);
  constexpr double kAroundPoint = 0.02;  // of what is framed: a point has no size to go by
  const double whole = (to_point(box_.max) - to_point(box_.min)).norm();
  const double own = (to_point(box.max) - to_point(box.min)).norm();
  const double size = std::max(1e-3, own < 1e-9 * whole ? kAroundPoint * whole : own);
  if constexpr (D == 3) {
    choice_.target = to_point(box.center());
    choice_.distance = 2.5 * size;
  } else {
    choice_.center = to_point(box.center()).template head<2>();
    choice_.width = 4 * size;
  }
}

template <int D>
void Orbit<D>::face(std::string_view direction) {
  if constexpr (D == 3) {
    const CameraChoice<3> from = parse_camera<3>(direction);
    choice_.yaw = from.yaw;
    choice_.pitch = from.pitch;
  }
}

template class Orbit<2>;
template class Orbit<3>;

}  // namespace kerf
