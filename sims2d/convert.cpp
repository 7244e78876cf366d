#include "sims2d/convert.h"

#include <box2d/b2_circle_shape.h>
#include <box2d/b2_polygon_shape.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/base/overloaded.h"
#include "core/scene/bounding.h"

namespace kerf::inline sims2d {
namespace {

void check_size(Scalar size) {
  if (!std::isfinite(size) || size <= 0)
    throw std::invalid_argument("the size of a shape must be positive and finite, not " +
                                std::to_string(size));
}

std::unique_ptr<b2Shape> disc(const Ball& ball) {
  check_size(ball.radius);
  auto circle = std::make_unique<b2CircleShape>();
  circle->m_radius = ball.radius;
  return circle;
}

std::unique_ptr<b2Shape> brick(const Brick<2>& brick) {
  check_size(brick.half[0]);
  check_size(brick.half[1]);
  auto polygon = std::make_unique<b2PolygonShape>();
  polygon->SetAsBox(brick.half[0], brick.half[1]);
  return polygon;
}

Scalar turn(const Vector<2>& a, const Vector<2>& b, const Vector<2>& c) {
  const Vector<2> u = b - a;
  const Vector<2> v = c - b;
  return u[0] * v[1] - u[1] * v[0];
}

bool turns_left(const std::vector<Vector<2>>& corners) {
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i)
    if (!(turn(corners[i], corners[(i + 1) % count], corners[(i + 2) % count]) > 0)) return false;
  return true;
}

/// Whether Box2D kept every corner (it welds close ones) in the given order (it makes a hull).
bool kept(const b2PolygonShape& polygon, const std::vector<Vector<2>>& corners) {
  const std::size_t count = corners.size();
  if (polygon.m_count != static_cast<int32>(count)) return false;
  const Vector<2> first{{polygon.m_vertices[0].x, polygon.m_vertices[0].y}};
  const auto start =
      static_cast<std::size_t>(std::find(corners.begin(), corners.end(), first) - corners.begin());
  for (std::size_t i = 0; i < count; ++i) {
    const Vector<2>& corner = corners[(start + i) % count];
    if (polygon.m_vertices[i] != b2Vec2(corner[0], corner[1])) return false;
  }
  return true;
}

std::unique_ptr<b2Shape> polygon(const Outline& outline) {
  const std::size_t count = outline.corners.size();
  if (count < 3 || count > b2_maxPolygonVertices)
    throw std::invalid_argument("an outline has 3 to 8 corners, not " + std::to_string(count));
  std::array<b2Vec2, b2_maxPolygonVertices> points{};
  for (std::size_t i = 0; i < count; ++i) points[i].Set(outline.corners[i][0], outline.corners[i][1]);
  auto polygon = std::make_unique<b2PolygonShape>();
  const bool convex = turns_left(outline.corners);
  if (convex) polygon->Set(points.data(), static_cast<int32>(count));
  if (!convex || !kept(*polygon, outline.corners))
    throw std::invalid_argument(
        "an outline must be strictly convex and counter-clockwise, its corners 0.01 apart");
  return polygon;
}

}  // namespace

std::unique_ptr<b2Shape> to_box2d(const Shape<2>& shape) {
  return std::visit(
      Overloaded{[](const Ball& ball) { return disc(ball); }, [](const Brick<2>& box) { return brick(box); },
                 [](const Outline& outline) { return polygon(outline); }},
      shape);
}

Pose<2> to_pose(const b2Transform& transform) {
  const b2Rot& q = transform.q;
  return {{{transform.p.x, transform.p.y}}, {Vector<2>{{q.c, q.s}}, Vector<2>{{-q.s, q.c}}}};
}

Volume<2> padded_volume(VolumeKind kind, const Shape<2>& shape, const b2Shape& engine_shape,
                        const b2Transform& transform) {
  if (kind == VolumeKind::box) return make_box_volume(padded_box(engine_shape, transform));
  // The skin of polygons, which Box2D's bounds contain already.
  constexpr double kMargin = static_cast<double>(b2_polygonRadius) + static_cast<double>(kBoxPadding);
  return bound(kind, shape, precise(to_pose(transform)), kMargin);
}

}  // namespace kerf::inline sims2d
