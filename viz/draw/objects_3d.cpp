#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "core/base/overloaded.h"
#include "viz/draw/draw_context.h"
#include "viz/draw/least_shape.h"
#include "viz/draw/palette.h"
#include "viz/draw/shading.h"
#include "viz/draw/sphere_mesh.h"
#include "viz/draw/strokes.h"

namespace kerf {
namespace {

constexpr double kGlassAlpha = 0.10;
constexpr double kEdgeLight = 0.55;    // light of an object's edges
constexpr double kEdgePixels = 1.1;    // their width
constexpr double kFewestEdges = 7;     // smaller objects, in rims, have none: they would be nothing else
constexpr double kBeforeEdge = 1e-5;   // of the depths that the rasteriser compares
constexpr double kFewestCorners = 12;  // of the disc behind a ball, which is its rim
constexpr double kWallSlope = 0.5;     // steeper faces of fixed objects are walls, of glass

/// A body's frame seen by the camera; all decisions about a face are made in it.
struct Frame {
  Eigen::Matrix4d clip_from_body;
  Eigen::Vector3d eye;    ///< in the body's frame
  Eigen::Vector3d light;  ///< likewise; unit, towards the light
  Eigen::Vector3d up;     ///< likewise
};

Frame frame_of(const View& view, const Pose<3>& pose) {
  Eigen::Matrix4d world_from_body = Eigen::Matrix4d::Identity();
  for (int i = 0; i < 3; ++i)
    world_from_body.col(i).head<3>() = to_point(pose.axes[static_cast<std::size_t>(i)]);
  world_from_body.topRightCorner<3, 1>() = to_point(pose.position);
  const Eigen::Matrix3d axes = world_from_body.topLeftCorner<3, 3>();
  return {view.clip_from_world * world_from_body, axes.transpose() * (view.eye - to_point(pose.position)),
          axes.transpose() * light_of(view), axes.transpose() * Eigen::Vector3d::UnitY()};
}

Color lit_face(const Frame& frame, const Eigen::Vector3d& normal, Color color) {
  return kerf::lit_face(color, normal.dot(frame.light));
}

Eigen::Vector4d to_clip(const Frame& frame, const Eigen::Vector3d& p) {
  return frame.clip_from_body.col(0) * p.x() + frame.clip_from_body.col(1) * p.y() +
         frame.clip_from_body.col(2) * p.z() + frame.clip_from_body.col(3);
}

/// Panes of glass wait until all are known, to be drawn from back to front.
struct Pane {
  double distance = 0;
  std::array<Eigen::Vector4d, 4> corners;
  std::array<Eigen::Vector3d, 4> world;
  Color color;
  std::uint32_t item = 0;
};

/// What all squares that face the eye have in common, in clip coordinates.
struct Facing {
  Eigen::Vector4d right;  ///< of a unit length
  Eigen::Vector4d up;
  double light = 0;  ///< the cosine between their normal and the way to the light

  explicit Facing(const View& view)
      : right(view.clip_from_world.leftCols<3>() * view.right),
        up(view.clip_from_world.leftCols<3>() * view.right.cross(view.forward)),
        light(-view.forward.dot(light_of(view))) {}
};

struct Targets {
  const DrawContext<3>& context;
  const Facing facing;
  Batch& solid;
  Batch& glass;
  std::vector<Pane>& panes;
  double pixels = 1;  ///< of a unit length where the object is

  /// Whether an object so large, from its middle to its side, is drawn with its edges.
  [[nodiscard]] bool has_rim(double half) const {
    return !context.brief && 2 * half * pixels > kFewestEdges * kEdgePixels * context.line_scale;
  }
};

/// A disc behind the ball, a little larger: what is seen of it is the ball's outline.
void draw_disc(const Targets& to, const Frame& frame, double radius, Color color) {
  const Eigen::Vector3d way = frame.eye.normalized();
  const Eigen::Vector3d u = way.unitOrthogonal();
  const Eigen::Vector3d v = way.cross(u);
  const double distance = std::max(frame.eye.norm(), 1.001 * radius);
  // The outline of a ball that is near lies before its middle.
  const double depth = radius * radius / distance;
  const double seen = std::sqrt(std::max(0.0, radius * radius - depth * depth));
  const double rim = seen + kEdgePixels * to.context.line_scale / to.pixels;
  const auto corners = static_cast<int>(kFewestCorners + std::sqrt(radius * to.pixels));
  std::vector<Eigen::Vector4d> clip;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    clip.push_back(to_clip(frame, depth * way + rim * (std::cos(angle) * u + std::sin(angle) * v)));
  }
  to.solid.add_fan(clip, color);
}

void draw_ball(const Targets& to, const Frame& frame, const Ball& ball, Color color) {
  const double radius = ball.radius;
  if (to.has_rim(radius)) draw_disc(to, frame, radius, lit(color, kEdgeLight));
  const SphereMesh& mesh = sphere_mesh_for(radius * to.pixels);
  for (const SphereMesh::Face& face : mesh.faces) {
    if (face.normal.dot(frame.eye) <= face.height * radius) continue;
    const Color shade = lit_face(frame, face.normal, color);
    std::uint32_t index = 0;
    for (const std::uint32_t corner : face.corners)
      index = to.solid.add_vertex(to_clip(frame, mesh.vertices[corner] * radius), shade);
    to.solid.add_triangle(index - 2, index - 1, index);
  }
}

Pane make_pane(const Body<3>& body, const std::array<Eigen::Vector3d, 4>& corners,
               const std::array<Eigen::Vector4d, 4>& clip, const View& view, Color color) {
  Pane pane{0, clip, {}, color, 0};
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    pane.world[i] = to_point(body.pose.position);
    for (int axis = 0; axis < 3; ++axis)
      pane.world[i] += corners[i][axis] * to_point(body.pose.axes[static_cast<std::size_t>(axis)]);
    center += 0.25 * pane.world[i];
  }
  pane.distance = (center - view.eye).norm();
  return pane;
}

/// A side of a box, seen from outside; `inset`: how far its corners lie within its own.
struct Side {
  int axis = 0;
  double sign = 1;
  double inset = 0;
};

std::array<Eigen::Vector3d, 4> corners_of(const Brick<3>& brick, const Side& side) {
  const int u = (side.axis + 1) % 3;
  const int v = (side.axis + 2) % 3;
  std::array<Eigen::Vector3d, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    corners[i][side.axis] = side.sign * double{brick.half[side.axis]};
    corners[i][u] = (i == 0 || i == 3 ? -1 : 1) * (double{brick.half[u]} - side.inset);
    corners[i][v] = (i < 2 ? -1 : 1) * (double{brick.half[v]} - side.inset);
  }
  return corners;
}

std::array<Eigen::Vector4d, 4> to_clip(const Frame& frame, const std::array<Eigen::Vector3d, 4>& corners) {
  std::array<Eigen::Vector4d, 4> clip;
  std::ranges::transform(corners, clip.begin(), [&](const Eigen::Vector3d& p) { return to_clip(frame, p); });
  return clip;
}

/// Filled twice, dark and then smaller and a hair nearer: a rim for the price of one more fan.
void draw_side(const Targets& to, const Frame& frame, const Brick<3>& brick, Side side, Color color) {
  const int u = (side.axis + 1) % 3;
  const int v = (side.axis + 2) % 3;
  const bool has_rim = to.has_rim(std::min(double{brick.half[u]}, double{brick.half[v]}));
  to.solid.add_fan(to_clip(frame, corners_of(brick, side)), has_rim ? lit(color, kEdgeLight) : color);
  if (!has_rim) return;
  side.inset = kEdgePixels * to.context.line_scale / to.pixels;
  auto inner = to_clip(frame, corners_of(brick, side));
  for (Eigen::Vector4d& corner : inner) corner.z() -= kBeforeEdge * corner.w();
  to.solid.add_fan(inner, color);
}

void draw_brick(const Targets& to, const Frame& frame, const Body<3>& body, const Brick<3>& brick,
                Color color) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const Eigen::Vector3d normal = sign * Eigen::Vector3d::Unit(axis);
      if (normal.dot(frame.eye) <= double{brick.half[axis]}) continue;
      const Color shade = lit_face(frame, normal, color);
      if (body.mobility == Mobility::moving) {
        draw_side(to, frame, brick, {axis, sign}, shade);
        continue;
      }
      const auto corners = corners_of(brick, {axis, sign});
      const auto clip = to_clip(frame, corners);
      if (normal.dot(frame.up) < kWallSlope) {
        to.panes.push_back(make_pane(body, corners, clip, to.context.view, shade));
        to.panes.back().item = to.glass.item;
      } else {
        to.solid.add_fan(clip, shade);
      }
    }
  }
}

void draw_surface(const Targets& to, const Frame& frame, const Surface& surface, Color color) {
  for (const std::array<std::uint32_t, 3>& triangle : surface.triangles) {
    if (std::ranges::any_of(triangle, [&](std::uint32_t i) { return i >= surface.vertices.size(); }))
      continue;
    const Eigen::Vector3d a = to_point(surface.vertices[triangle[0]]);
    const Eigen::Vector3d b = to_point(surface.vertices[triangle[1]]);
    const Eigen::Vector3d c = to_point(surface.vertices[triangle[2]]);
    const Eigen::Vector3d normal = (b - a).cross(c - a).normalized();
    const std::array<Eigen::Vector4d, 3> clip{to_clip(frame, a), to_clip(frame, b), to_clip(frame, c)};
    // From behind, ground is glass: the rim of a valley must not hide its inside.
    const bool is_front = normal.dot(frame.eye - a) > 0;
    if (is_front) {
      to.solid.add_fan(clip, lit_face(frame, normal, color));
    } else {
      to.glass.add_fan(clip, with_alpha(color, kGlassAlpha));
    }
  }
}

/// A little lighter or darker than others of its colour: neighbours differ, and one can be followed.
Color varied(Color color, std::size_t object) {
  const auto mixed = static_cast<std::uint32_t>(object * 2654435769U);
  return lit(color, 0.92 + 0.12 * (static_cast<double>(mixed >> 8U) / (1U << 24U)));
}

Color color_of(const DrawContext<3>& context, std::size_t object) {
  const Body<3>& body = context.input.bodies[object];
  const Color color = object_color(context, object);
  const bool varies = body.mobility == Mobility::moving && color != palette::kStraddler;
  return mix(context.ground, varies ? varied(color, object) : color,
             clearness(context.view, to_point(body.pose.position)));
}

/// From its middle to its sides, if these are about as far from it as each other; else infinite.
double radius_of(const Shape<3>& shape) {
  constexpr double kLong = std::numeric_limits<double>::infinity();
  constexpr double kAlike = 1.6;
  return std::visit(
      Overloaded{
          [](const Ball& ball) { return double{ball.radius}; },
          [](const Brick<3>& brick) {
            const auto [least, most] = std::minmax({brick.half[0], brick.half[1], brick.half[2]});
            return most <= kAlike * least ? 0.5 * (double{least} + most) : kLong;
          },
          [](const std::shared_ptr<const Surface>&) { return kLong; },
      },
      shape);
}

/// A square that faces the eye. False where the object is too large or too long for that.
bool draw_patch(const Targets& to, const Body<3>& body, const Shape<3>& shape, Color color) {
  constexpr double kLargest = 14;     // pixels
  constexpr double kSeenSides = 1.1;  // a box that is seen from a corner covers more than a side
  const double radius = radius_of(shape);
  if (body.mobility != Mobility::moving || 2 * radius * to.pixels > kLargest) return false;
  const Eigen::Vector4d middle = to.context.view.clip_from_world * to_point(body.pose.position).homogeneous();
  const Eigen::Vector4d right = kSeenSides * radius * to.facing.right;
  const Eigen::Vector4d up = kSeenSides * radius * to.facing.up;
  const std::array<Eigen::Vector4d, 4> corners{middle - right - up, middle + right - up, middle + right + up,
                                               middle - right + up};
  to.solid.add_fan(corners, kerf::lit_face(color, to.facing.light));
  return true;
}

/// A disc that faces the eye, and a smaller one a hair nearer.
void draw_dot(const Targets& to, const Body<3>& body, Color color) {
  constexpr double kInside = 0.6;  // of its radius; the rest is the rim
  const Eigen::Vector4d middle = to.context.view.clip_from_world * to_point(body.box.center()).homogeneous();
  const double rim = dot_radius(to.context, to.pixels);
  const auto add_disc = [&](double radius, double nearer, Color of) {
    std::array<Eigen::Vector4d, static_cast<std::size_t>(kFewestCorners)> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(i) / kFewestCorners;
      corners[i] = middle + radius * (std::cos(angle) * to.facing.right + std::sin(angle) * to.facing.up);
      corners[i].z() -= nearer * corners[i].w();
    }
    to.solid.add_fan(corners, of);
  };
  add_disc(rim, 0, lit(color, kEdgeLight));
  add_disc(kInside * rim, kBeforeEdge, kerf::lit_face(color, to.facing.light));
}

void draw_body(Targets& to, std::size_t object) {
  const Body<3>& body = to.context.input.bodies[object];
  const Color color = color_of(to.context, object);
  to.pixels = to.context.view.pixels_per_unit(to_point(body.pose.position));
  to.context.begin(to.solid, DrawnKind::object, static_cast<std::uint32_t>(object));
  to.glass.item = to.solid.item;
  if (is_point(body.box, to.pixels)) return draw_dot(to, body, color);
  const std::optional<Shape<3>> least = least_shape(body, least_half(to.context, to.pixels));
  const Shape<3>& shape = least ? *least : body.shape;
  if (to.context.brief && draw_patch(to, body, shape, color)) return;
  const Frame frame = frame_of(to.context.view, body.pose);
  std::visit(Overloaded{
                 [&](const Ball& ball) { draw_ball(to, frame, ball, color); },
                 [&](const Brick<3>& brick) { draw_brick(to, frame, body, brick, color); },
                 [&](const std::shared_ptr<const Surface>& surface) {
                   if (surface) draw_surface(to, frame, *surface, color);
                 },
             },
             shape);
}

/// What is hidden then costs little: the rasteriser computes no colour for it.
std::vector<std::uint32_t> nearest_first(const DrawContext<3>& context) {
  std::vector<std::pair<double, std::uint32_t>> order;
  for (std::uint32_t object = 0; object < context.input.bodies.size(); ++object) {
    const Body<3>& body = context.input.bodies[object];
    if (is_drawable(body)) order.emplace_back(context.view.forward.dot(to_point(body.pose.position)), object);
  }
  std::ranges::sort(order);
  std::vector<std::uint32_t> objects(order.size());
  std::ranges::transform(order, objects.begin(), [](const auto& entry) { return entry.second; });
  return objects;
}

}  // namespace

void draw_objects(const DrawContext<3>& context, Batch& solid, Batch& glass) {
  std::vector<Pane> panes;
  Targets to{context, Facing(context.view), solid, glass, panes};
  for (const std::uint32_t object : nearest_first(context)) draw_body(to, object);
  std::ranges::stable_sort(panes, std::ranges::greater{}, &Pane::distance);
  const Stroke edge{with_alpha(palette::kFaintInk, 0.45), context.line_scale};
  for (const Pane& pane : panes) {
    glass.item = pane.item;
    glass.add_fan(pane.corners, with_alpha(pane.color, kGlassAlpha));
    add_outline(glass, context.view, pane.world, edge);
  }
}

}  // namespace kerf
