#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/overloaded.h"
#include "viz/draw/draw_context.h"
#include "viz/draw/ground.h"
#include "viz/draw/palette.h"
#include "viz/draw/shading.h"
#include "viz/draw/strokes.h"

namespace kerf {
namespace {

constexpr double kHighest = 8;       ///< an object so many times its size above the ground has no shadow
constexpr double kCoreShade = 0.30;  ///< how dark a shadow is where the object touches the ground
constexpr double kRimShade = 0.13;
constexpr double kCoreSize = 0.92;  ///< of the outline seen from above
constexpr double kRimSize = 1.2;
constexpr double kLift = 0.02;   ///< above the ground, of the object's size
constexpr double kSmallest = 2;  ///< pixels

/// Offsets in x and z.
using Footprint = std::vector<Eigen::Vector2d>;

/// The outline of a box seen from above: the sum of its three axes as segments.
Footprint footprint_of(const Pose<3>& pose, const Brick<3>& brick) {
  std::array<Eigen::Vector2d, 3> arms;
  for (std::size_t i = 0; i < 3; ++i) {
    const double half = brick.half[static_cast<int>(i)];
    arms[i] = half * Eigen::Vector2d(double{pose.axes[i][0]}, double{pose.axes[i][2]});
    if (arms[i].y() < 0 || (arms[i].y() == 0 && arms[i].x() < 0)) arms[i] = -arms[i];
  }
  std::ranges::sort(arms, [](const auto& a, const auto& b) { return a.x() * b.y() - a.y() * b.x() > 0; });
  Footprint corners;
  Eigen::Vector2d at = -(arms[0] + arms[1] + arms[2]);
  for (const double way : {2.0, -2.0})
    for (const Eigen::Vector2d& arm : arms) {
      corners.push_back(at);
      at += way * arm;
    }
  return corners;
}

Footprint footprint_of(const Ball& ball) {
  constexpr int kCorners = 12;
  Footprint corners;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    corners.emplace_back(double{ball.radius} * std::cos(angle), double{ball.radius} * std::sin(angle));
  }
  return corners;
}

Footprint footprint_of(const Body<3>& body) {
  return std::visit(Overloaded{
                        [](const Ball& ball) { return footprint_of(ball); },
                        [&](const Brick<3>& brick) { return footprint_of(body.pose, brick); },
                        [](const std::shared_ptr<const Surface>&) { return Footprint(); },
                    },
                    body.shape);
}

/// As the ground is drawn.
Color color_of(const DrawContext<3>& context, const GroundPlane& plane, const Eigen::Vector3d& point) {
  if (!plane.is_body) return context.ground;
  const Eigen::Vector3d normal = Eigen::Vector3d(-plane.slope_x, 1, -plane.slope_z).normalized();
  const Color color = lit_face(palette::kFixed, normal.dot(light_of(context.view)));
  return mix(context.ground, color, clearness(context.view, point));
}

void add_shadow(const DrawContext<3>& context, const Body<3>& body, const Ground& ground, Batch& batch) {
  const Eigen::Vector3d middle = to_point(body.box.center());
  const Vector<3> extent = body.box.extent();
  const double size = std::max({extent[0], extent[1], extent[2]});
  if (!(size * context.view.pixels_per_unit(middle) > kSmallest)) return;
  const GroundPlane plane = ground.below(middle);
  const double gap = std::max(0.0, double{body.box.min[1]} - plane.height);
  const double strength = 1 - gap / (kHighest * size);
  if (strength <= 0) return;
  const Color lit_ground = color_of(context, plane, middle);
  const Footprint footprint = footprint_of(body);
  const auto fill = [&](double scale, double shade) {
    thread_local Polygon polygon;
    polygon.clear();
    for (const Eigen::Vector2d& at : footprint) {
      const Eigen::Vector2d from = scale * at;
      polygon.emplace_back(middle.x() + from.x(),
                           plane.height + kLift * size + plane.slope_x * from.x() + plane.slope_z * from.y(),
                           middle.z() + from.y());
    }
    add_polygon(batch, context.view, polygon, lit(lit_ground, 1 - shade * strength));
  };
  fill(kRimSize, kRimShade);
  fill(kCoreSize, kCoreShade);
}

}  // namespace

void draw_shadows(const DrawContext<3>& context, Batch& shadows) {
  const Ground ground(context.input.bodies, context.bounds);
  for (const Body<3>& body : context.input.bodies)
    if (body.mobility == Mobility::moving && is_drawable(body)) add_shadow(context, body, ground, shadows);
}

}  // namespace kerf
