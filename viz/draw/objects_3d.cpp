#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/overloaded.h"
#include "viz/draw/draw_context.h"
#include "viz/draw/palette.h"
#include "viz/draw/sphere_mesh.h"
#include "viz/draw/strokes.h"

namespace kerf {
namespace {

constexpr double kAmbient = 0.62;
constexpr double kGlassAlpha = 0.10;
constexpr double kWallSlope = 0.5;  // steeper faces of fixed objects are walls, of glass

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
  // The light comes from above, over the viewer's left shoulder.
  const Eigen::Vector3d level(view.forward.z(), 0, -view.forward.x());
  const Eigen::Vector3d light = (Eigen::Vector3d(0, 1.2, 0) - 0.7 * view.forward + 0.5 * level).normalized();
  return {view.clip_from_world * world_from_body, axes.transpose() * (view.eye - to_point(pose.position)),
          axes.transpose() * light, axes.transpose() * Eigen::Vector3d::UnitY()};
}

Color lit_face(const Frame& frame, const Eigen::Vector3d& normal, Color color) {
  return lit(color, kAmbient + (1.08 - kAmbient) * std::max(0.0, normal.dot(frame.light)));
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

struct Targets {
  const DrawContext<3>& context;
  Batch& solid;
  Batch& glass;
  std::vector<Pane>& panes;
};

void draw_ball(const Targets& to, const Frame& frame, const Ball& ball, double pixels_per_unit, Color color) {
  const double radius = ball.radius;
  const SphereMesh& mesh = sphere_mesh_for(radius * pixels_per_unit);
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

void draw_brick(const Targets& to, const Frame& frame, const Body<3>& body, const Brick<3>& brick,
                Color color) {
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    for (const double sign : {-1.0, 1.0}) {
      const Eigen::Vector3d normal = sign * Eigen::Vector3d::Unit(axis);
      if (normal.dot(frame.eye) <= double{brick.half[axis]}) continue;
      std::array<Eigen::Vector3d, 4> corners;
      std::array<Eigen::Vector4d, 4> clip;
      for (std::size_t i = 0; i < 4; ++i) {
        corners[i][axis] = sign * double{brick.half[axis]};
        corners[i][u] = (i == 0 || i == 3 ? -1 : 1) * double{brick.half[u]};
        corners[i][v] = (i < 2 ? -1 : 1) * double{brick.half[v]};
        clip[i] = to_clip(frame, corners[i]);
      }
      const Color shade = lit_face(frame, normal, color);
      const bool is_wall = body.mobility == Mobility::fixed && normal.dot(frame.up) < kWallSlope;
      if (is_wall) {
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

void draw_body(const Targets& to, std::size_t object) {
  const Body<3>& body = to.context.input.bodies[object];
  const Frame frame = frame_of(to.context.view, body.pose);
  const Color color = object_color(to.context, object);
  to.context.begin(to.solid, DrawnKind::object, static_cast<std::uint32_t>(object));
  to.glass.item = to.solid.item;
  std::visit(Overloaded{
                 [&](const Ball& ball) {
                   const double pixels = to.context.view.pixels_per_unit(to_point(body.pose.position));
                   draw_ball(to, frame, ball, pixels, color);
                 },
                 [&](const Brick<3>& brick) { draw_brick(to, frame, body, brick, color); },
                 [&](const std::shared_ptr<const Surface>& surface) {
                   if (surface) draw_surface(to, frame, *surface, color);
                 },
             },
             body.shape);
}

}  // namespace

void draw_objects(const DrawContext<3>& context, Batch& solid, Batch& glass) {
  std::vector<Pane> panes;
  const Targets to{context, solid, glass, panes};
  for (std::size_t object = 0; object < context.input.bodies.size(); ++object)
    if (is_drawable(context.input.bodies[object])) draw_body(to, object);
  std::ranges::stable_sort(panes, std::ranges::greater{}, &Pane::distance);
  const Stroke edge{with_alpha(palette::kFaintInk, 0.45), context.line_scale};
  for (const Pane& pane : panes) {
    glass.item = pane.item;
    glass.add_fan(pane.corners, with_alpha(pane.color, kGlassAlpha));
    add_outline(glass, context.view, pane.world, edge);
  }
}

}  // namespace kerf
