#pragma once

#include <box2d/b2_fixture.h>
#include <box2d/b2_shape.h>

#include <memory>

#include "core/geometry/box.h"
#include "core/geometry/volume.h"
#include "core/scene/shape.h"

namespace kerf::inline sims2d {

/// How far each box reaches beyond Box2D's own bounds of the shape, so that everything that touches overlaps.
///
/// Box2D calls two polygons touching when the largest separation along a face normal is at most r, the sum of
/// their skins (2 * 0.01), and keeps manifold points up to r beyond the ends of the reference face. Two
/// corners that meet tip to tip may thus touch at a distance of sqrt(2) * r = 0.0283, while Box2D's bounds
/// reach only r = 0.02. The missing 0.0083, half on each side, and the rounding of coordinates up to 10,000
/// units fit into 0.01 a side.
inline constexpr Scalar kBoxPadding = 0.01F;

/// The shape as Box2D's narrow phase takes it. Throws std::invalid_argument for sizes that are not positive
/// and finite, and for outlines that are not strictly convex, counter-clockwise and of 3 to 8 corners.
std::unique_ptr<b2Shape> to_box2d(const Shape<2>& shape);

Pose<2> to_pose(const b2Transform& transform);

/// The padded box of a shape at a pose, as the broad phase gets it.
Box<2> padded_box(const b2Shape& shape, const b2Transform& transform);

/// The padded volume of the given kind around a body's shape at a pose.
Volume<2> padded_volume(VolumeKind kind, const Shape<2>& shape, const b2Shape& engine_shape,
                        const b2Transform& transform);

}  // namespace kerf::inline sims2d
