#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "core/base/overloaded.h"
#include "viz/draw/draw_context.h"
#include "viz/draw/least_shape.h"
#include "viz/draw/palette.h"
#include "viz/draw/strokes.h"

namespace kerf {
namespace {

constexpr double kRimPixels = 1.2;

/// A convex outline around the body's origin in scene coordinates.
Polygon outline(const Pose<2>& pose, const Shape<2>& shape, double pixels_per_unit) {
  const Eigen::Vector3d origin = to_point(pose.position);
  const Eigen::Vector3d x = to_point(pose.axes[0]);
  const Eigen::Vector3d y = to_point(pose.axes[1]);
  Polygon polygon;
  const auto add_ball = [&](const Ball& ball) {
    const double radius = ball.radius;
    const int corners = std::clamp(static_cast<int>(6 + std::sqrt(radius * pixels_per_unit) * 3), 8, 64);
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      polygon.push_back(origin + radius * (std::cos(angle) * x + std::sin(angle) * y));
    }
  };
  const auto add_brick = [&](const Brick<2>& brick) {
    const Eigen::Vector3d u = x * double{brick.half[0]};
    const Eigen::Vector3d v = y * double{brick.half[1]};
    polygon = {origin - u - v, origin + u - v, origin + u + v, origin - u + v};
  };
  const auto add_outline = [&](const Outline& outline) {
    for (const Vector<2>& corner : outline.corners)
      polygon.push_back(origin + double{corner[0]} * x + double{corner[1]} * y);
  };
  std::visit(Overloaded{add_ball, add_brick, add_outline}, shape);
  return polygon;
}

/// Unit normal of the edge from p to q, to its left: inwards in a counter-clockwise polygon.
Eigen::Vector3d inward(const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
  const Eigen::Vector3d edge = q - p;
  const double length = edge.norm();
  return length > 0 ? Eigen::Vector3d(-edge.y() / length, edge.x() / length, 0) : Eigen::Vector3d::Zero();
}

/// The convex polygon with each edge moved inwards by `margin`.
Polygon inset(const Polygon& polygon, double margin) {
  const std::size_t count = polygon.size();
  Polygon result;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d before = inward(polygon[(i + count - 1) % count], polygon[i]);
    const Eigen::Vector3d after = inward(polygon[i], polygon[(i + 1) % count]);
    const double divisor = std::max(0.2, 1 + before.dot(after));  // a sharp corner must not fly off
    result.push_back(polygon[i] + (before + after) * (margin / divisor));
  }
  return result;
}

/// The part near the view of a box that is so large, or lies so far out, that floats do not hold its sides to
/// a pixel: neither those of a pose nor OpenGL's. Nothing for any other body. `least`: from its middle to
/// each side at least.
std::optional<Polygon> near_part(const DrawContext<2>& context, const Body<2>& body, double least) {
  constexpr double kPixels = 0.05;
  const Vector<2>& x = body.pose.axes[0];
  const bool is_box = std::visit(
      Overloaded{[](const Brick<2>&) { return true; }, NothingFor<bool, Ball, Outline>()}, body.shape);
  if (!is_box || x[0] != 1 || x[1] != 0) return std::nullopt;
  const auto [left, low, right, high] =
      std::array{body.box.min[0], body.box.min[1], body.box.max[0], body.box.max[1]};
  const double farthest = std::max({std::abs(left), std::abs(low), std::abs(right), std::abs(high)});
  const double step = farthest * double{std::numeric_limits<Scalar>::epsilon()};
  if (step * context.view.pixels_per_unit_at_one < kPixels) return std::nullopt;
  std::array<double, 2> from{};
  std::array<double, 2> to{};
  for (int i = 0; i < 2; ++i) {
    const double around = double{context.bounds.max[i]} - double{context.bounds.min[i]};
    const auto side = static_cast<std::size_t>(i);
    const double middle = 0.5 * double{body.box.min[i]} + 0.5 * double{body.box.max[i]};
    const double begin = std::min(double{body.box.min[i]}, middle - least);
    const double end = std::max(double{body.box.max[i]}, middle + least);
    from[side] = std::max(begin, double{context.bounds.min[i]} - around);
    to[side] = std::min(end, double{context.bounds.max[i]} + around);
    if (from[side] > to[side]) return Polygon();
  }
  return Polygon{{from[0], from[1], 0}, {to[0], from[1], 0}, {to[0], to[1], 0}, {from[0], to[1], 0}};
}

Polygon disc(const Eigen::Vector3d& middle, double radius) {
  constexpr int kCorners = 12;
  Polygon polygon;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    polygon.push_back(middle + radius * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0));
  }
  return polygon;
}

void draw_dot(const DrawContext<2>& context, const Body<2>& body, Color color, Batch& batch) {
  constexpr double kInside = 0.6;  // of its radius; the rest is the rim
  const double radius = dot_radius(context, context.view.pixels_per_unit_at_one);
  const Eigen::Vector3d middle = to_point(body.box.center());
  add_polygon(batch, context.view, disc(middle, radius), lit(color, 0.45));
  add_polygon(batch, context.view, disc(middle, kInside * radius), color);
}

/// Shapes are filled twice, dark and then smaller and light: a rim for the price of one more fan.
void draw_body(const DrawContext<2>& context, std::size_t object, Batch& batch) {
  const Body<2>& body = context.input.bodies[object];
  const double pixels = context.view.pixels_per_unit_at_one;
  const Color color = object_color(context, object);
  if (is_point(body.box, pixels)) {
    context.begin(batch, DrawnKind::object, static_cast<std::uint32_t>(object));
    return draw_dot(context, body, color, batch);
  }
  const double rim = kRimPixels * context.line_scale;
  const double half = least_half(context, pixels);
  const std::optional<Polygon> near = near_part(context, body, half);
  const std::optional<Shape<2>> least = least_shape(body, half);
  const Polygon polygon = near ? *near : outline(body.pose, least ? *least : body.shape, pixels);
  if (polygon.size() < 3) return;
  context.begin(batch, DrawnKind::object, static_cast<std::uint32_t>(object));
  const Vector<2> extent = body.box.extent();
  const bool is_large = std::min(extent[0], extent[1]) * pixels > 6 * rim;
  add_polygon(batch, context.view, polygon, is_large ? lit(color, 0.45) : color);
  if (!is_large) return;
  add_polygon(batch, context.view, inset(polygon, rim / pixels), color);
  const auto add_spoke = [&](const Ball& ball) {  // shows how it turns
    const Eigen::Vector3d origin = to_point(body.pose.position);
    const Eigen::Vector3d end = origin + double{ball.radius} * to_point(body.pose.axes[0]);
    add_line(batch, context.view, origin, end, {lit(color, 0.45), rim});
  };
  std::visit(Overloaded{add_spoke, NothingFor<void, Brick<2>, Outline>()}, body.shape);
}

}  // namespace

void draw_objects(const DrawContext<2>& context, Batch& flat) {
  // Fixed objects lie behind moving ones.
  for (const Mobility mobility : {Mobility::fixed, Mobility::moving}) {
    for (std::size_t object = 0; object < context.input.bodies.size(); ++object) {
      const Body<2>& body = context.input.bodies[object];
      if (body.mobility == mobility && is_drawable(body)) draw_body(context, object, flat);
    }
  }
}

void draw_leaves(const DrawContext<2>& context, Batch& batch) {
  constexpr double kAlpha = 0.5;
  if (context.snapshot.empty()) return;
  for (const NodeId id : back_to_front(context.snapshot, Eigen::Vector3d::Zero())) {
    const TreeSnapshot::Node& node = context.snapshot[id];
    if (!node.is_leaf()) continue;
    const Color color = palette::population_color(node.population, context.largest_population);
    context.begin(batch, DrawnKind::leaf, id.value);
    for (const Polygon& cell : cell_faces(context.snapshot, id, context.bounds))
      add_polygon(batch, context.view, cell, with_alpha(color, kAlpha));
  }
}

}  // namespace kerf
