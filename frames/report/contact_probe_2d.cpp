#include <box2d/b2_circle_shape.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_polygon_shape.h>

#include <algorithm>
#include <utility>

#include "frames/report/contact_probe.h"
#include "sims2d/convert.h"

namespace kerf {
namespace {

/// Box2D has manifolds of a polygon and a circle, in this order, or of two of a kind.
b2Manifold collide(const b2Shape& a, const b2Transform& at_a, const b2Shape& b, const b2Transform& at_b) {
  b2Manifold manifold{};
  const auto* const circle_b = dynamic_cast<const b2CircleShape*>(&b);
  if (const auto* const circle_a = dynamic_cast<const b2CircleShape*>(&a)) {
    b2CollideCircles(&manifold, circle_a, at_a, circle_b, at_b);
    return manifold;
  }
  const auto* const polygon_a = dynamic_cast<const b2PolygonShape*>(&a);
  if (circle_b != nullptr) {
    b2CollidePolygonAndCircle(&manifold, polygon_a, at_a, circle_b, at_b);
  } else {
    b2CollidePolygons(&manifold, polygon_a, at_a, dynamic_cast<const b2PolygonShape*>(&b), at_b);
  }
  return manifold;
}

}  // namespace

void ContactProbe2::add(const Shape<2>& shape) {
  b2Transform origin;
  origin.SetIdentity();
  objects_.push_back({shape, to_box2d(shape), origin});
}

void ContactProbe2::place(ObjectId object, const Pose<2>& pose) {
  b2Transform& transform = objects_[object.index()].transform;
  transform.p.Set(pose.position[0], pose.position[1]);
  transform.q.c = pose.axes[0][0];
  transform.q.s = pose.axes[0][1];
}

Volume<2> ContactProbe2::volume(VolumeKind kind, ObjectId object) const {
  const Object& o = objects_[object.index()];
  return padded_volume(kind, o.shape, *o.engine, o.transform);
}

std::optional<double> ContactProbe2::depth(Pair pair) const {
  const Object* a = &objects_[pair.a.index()];
  const Object* b = &objects_[pair.b.index()];
  if (a->engine->GetType() == b2Shape::e_circle && b->engine->GetType() != b2Shape::e_circle) std::swap(a, b);
  const b2Manifold manifold = collide(*a->engine, a->transform, *b->engine, b->transform);
  if (manifold.pointCount == 0) return std::nullopt;
  b2WorldManifold world{};
  world.Initialize(&manifold, a->transform, a->engine->m_radius, b->transform, b->engine->m_radius);
  float nearest = world.separations[0];
  for (int32 k = 1; k < manifold.pointCount; ++k) nearest = std::min(nearest, world.separations[k]);
  return -static_cast<double>(nearest);
}

}  // namespace kerf
