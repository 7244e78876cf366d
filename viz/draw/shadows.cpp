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

constexpr double kHighest = 6;  ///< an object so many times its least extent above the ground has no shadow
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

double size_of(const Body<3>& body) {
  const Vector<3> extent = body.box.extent();
  return *std::ranges::max_element(extent.value);
}

/// As the ground is drawn.
Color color_of(const DrawContext<3>& context, const GroundPlane& plane, const Eigen::Vector3d& point) {
  if (!plane.is_body) return context.ground;
  const Eigen::Vector3d normal = Eigen::Vector3d(-plane.slope_x, 1, -plane.slope_z).normalized();
  const Color color = lit_face(palette::kFixed, normal.dot(light_of(context.view)));
  return mix(context.ground, color, clearness(context.view, point));
}

/// One of the two parts of a shadow.
struct Shade {
  double scale = 1;  ///< of the outline seen from above
  double shade = 0;  ///< how much darker it is than the ground
};

void draw_shade(const DrawContext<3>& context, const Body<3>& body, const GroundPlane& plane,
                const Shade& part, Batch& batch) {
  const Eigen::Vector3d middle = to_point(body.box.center());
  const double height = plane.height + kLift * size_of(body);
  thread_local Polygon polygon;
  polygon.clear();
  for (const Eigen::Vector2d& corner : footprint_of(body)) {
    const Eigen::Vector2d at = part.scale * corner;
    polygon.emplace_back(middle.x() + at.x(), height + plane.slope_x * at.x() + plane.slope_z * at.y(),
                         middle.z() + at.y());
  }
  add_polygon(batch, context.view, polygon, lit(color_of(context, plane, middle), 1 - part.shade));
}

void draw_shadow(const DrawContext<3>& context, const Body<3>& body, const Ground& ground, Batch& batch) {
  const Eigen::Vector3d middle = to_point(body.box.center());
  if (!(size_of(body) * context.view.pixels_per_unit(middle) > kSmallest)) return;
  const GroundPlane plane = ground.below(middle);
  const double gap = std::max(0.0, double{body.box.min[1]} - plane.height);
  const Vector<3> extent = body.box.extent();
  const double reach = kHighest * *std::ranges::min_element(extent.value);
  const double strength = reach > 0 ? 1 - gap / reach : 0;
  if (strength <= 0) return;
  draw_shade(context, body, plane, {kRimSize, kRimShade * strength}, batch);
  draw_shade(context, body, plane, {kCoreSize, kCoreShade * strength}, batch);
}

}  // namespace

void draw_shadows(const DrawContext<3>& context, Batch& shadows) {
  const Ground ground(context.input.bodies, context.bounds);
  for (const Body<3>& body : context.input.bodies)
    if (body.mobility == Mobility::moving && is_drawable(body)) draw_shadow(context, body, ground, shadows);
}

}  // namespace kerf
