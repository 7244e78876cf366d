#include "viz/draw/ground.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/overloaded.h"
#include "viz/draw/draw_context.h"

namespace kerf {
namespace {

constexpr std::size_t kSide = 32;  ///< columns along x, and along z

/// Whether a box lies level, so that its top is a piece of ground.
bool is_level(const Pose<3>& pose) {
  return std::ranges::any_of(pose.axes, [](const Vector<3>& axis) { return std::abs(axis[1]) > 0.9999F; });
}

/// The triangle's plane above or below a point, if the point lies over the triangle.
std::optional<GroundPlane> plane_of(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                    const Eigen::Vector3d& c, double x, double z) {
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  if (!(std::abs(normal.y()) > 1e-12)) return std::nullopt;
  const auto side = [&](const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
    return ((q.z() - p.z()) * (x - p.x()) - (q.x() - p.x()) * (z - p.z())) * (normal.y() > 0 ? 1 : -1);
  };
  if (side(a, b) < 0 || side(b, c) < 0 || side(c, a) < 0) return std::nullopt;
  const double slope_x = -normal.x() / normal.y();
  const double slope_z = -normal.z() / normal.y();
  return GroundPlane{a.y() + slope_x * (x - a.x()) + slope_z * (z - a.z()), slope_x, slope_z, true};
}

Eigen::Vector3d placed(const Pose<3>& pose, const Vector<3>& p) {
  Eigen::Vector3d world = to_point(pose.position);
  for (int axis = 0; axis < 3; ++axis)
    world += double{p[axis]} * to_point(pose.axes[static_cast<std::size_t>(axis)]);
  return world;
}

void take_surface(const Body<3>& body, const Surface& surface, const Eigen::Vector3d& point,
                  std::optional<GroundPlane>& best) {
  for (const auto& [i, k, l] : surface.triangles) {
    if (std::max({i, k, l}) >= surface.vertices.size()) continue;
    const auto plane =
        plane_of(placed(body.pose, surface.vertices[i]), placed(body.pose, surface.vertices[k]),
                 placed(body.pose, surface.vertices[l]), point.x(), point.z());
    if (plane && plane->height <= point.y() && (!best || plane->height > best->height)) best = plane;
  }
}

void take_top(const Body<3>& body, const Eigen::Vector3d& point, std::optional<GroundPlane>& best) {
  const double top = body.box.max[1];
  if (!is_level(body.pose) || top > point.y() || (best && top <= best->height)) return;
  best = GroundPlane{top, 0, 0, true};
}

bool is_over(const Box<3>& box, const Eigen::Vector3d& p) {
  return p.x() >= double{box.min[0]} && p.x() <= double{box.max[0]} && p.z() >= double{box.min[2]} &&
         p.z() <= double{box.max[2]};
}

}  // namespace

Ground::Ground(std::span<const Body<3>> bodies, const Box<3>& bounds)
    : bodies_(bodies), bounds_(bounds), columns_(kSide * kSide) {
  for (std::uint32_t k = 0; k < bodies.size(); ++k)
    if (bodies[k].mobility == Mobility::fixed && is_drawable(bodies[k])) add(k);
}

std::size_t Ground::column_of(double x, int axis) const {
  const double low = double{bounds_.min[axis]};
  const double part = (x - low) / std::max(1e-9, double{bounds_.max[axis]} - low);
  return static_cast<std::size_t>(std::clamp(part * kSide, 0.0, kSide - 1.0));
}

void Ground::add(std::uint32_t body) {
  const Box<3>& box = bodies_[body].box;
  for (std::size_t i = column_of(box.min[0], 0); i <= column_of(box.max[0], 0); ++i)
    for (std::size_t k = column_of(box.min[2], 2); k <= column_of(box.max[2], 2); ++k)
      columns_[i * kSide + k].push_back(body);
}

GroundPlane Ground::below(const Eigen::Vector3d& point) const {
  std::optional<GroundPlane> best;
  for (const std::uint32_t k : columns_[column_of(point.x(), 0) * kSide + column_of(point.z(), 2)]) {
    const Body<3>& body = bodies_[k];
    if (!is_over(body.box, point)) continue;
    std::visit(Overloaded{
                   [&](const std::shared_ptr<const Surface>& surface) {
                     if (surface) take_surface(body, *surface, point, best);
                   },
                   [&](const auto& /*ball or brick*/) { take_top(body, point, best); },
               },
               body.shape);
  }
  return best.value_or(GroundPlane{bounds_.min[1], 0, 0, false});
}

}  // namespace kerf
