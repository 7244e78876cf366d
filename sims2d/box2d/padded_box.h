#pragma once

#include <box2d/b2_collision.h>
#include <box2d/b2_math.h>
#include <box2d/b2_shape.h>

#include <cstdint>

#include "core/geometry/box.h"

namespace kerf {

/// How far each box reaches beyond Box2D's own bounds of the shape, so that everything that touches overlaps.
///
/// Box2D calls two polygons touching when the largest separation along a face normal is at most r, the sum of
/// their skins (2 * 0.01), and keeps manifold points up to r beyond the ends of the reference face. Two
/// corners that meet tip to tip may thus touch at a distance of sqrt(2) * r = 0.0283, while Box2D's bounds
/// reach only r = 0.02. The missing 0.0083, half on each side, and the rounding of coordinates up to 10,000
/// units fit into 0.01 a side.
inline constexpr Scalar kBoxPadding = 0.01F;

inline Box<2> to_box(const b2Vec2& min, const b2Vec2& max) { return {{{min.x, min.y}}, {{max.x, max.y}}}; }

/// The padded box of a shape's child at a pose, as the broad phase gets it.
inline Box<2> padded_box(const b2Shape& shape, const b2Transform& transform, std::int32_t child = 0) {
  b2AABB bounds;
  shape.ComputeAABB(&bounds, transform, child);
  const Vector<2> padding{{kBoxPadding, kBoxPadding}};
  return {Vector<2>{{bounds.lowerBound.x, bounds.lowerBound.y}} - padding,
          Vector<2>{{bounds.upperBound.x, bounds.upperBound.y}} + padding};
}

}  // namespace kerf
