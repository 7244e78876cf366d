#pragma once

#include <box2d/b2_fixture.h>
#include <box2d/b2_shape.h>

#include <memory>

#include "core/geometry/box.h"
#include "core/geometry/volume.h"
#include "core/scene/shape.h"
#include "sims2d/box2d/padded_box.h"

namespace kerf::inline sims2d {

/// The shape as Box2D's narrow phase takes it. Throws std::invalid_argument for sizes that are not positive
/// and finite, and for outlines that are not strictly convex, counter-clockwise and of 3 to 8 corners.
std::unique_ptr<b2Shape> to_box2d(const Shape<2>& shape);

Pose<2> to_pose(const b2Transform& transform);

/// The padded volume of the given kind around a body's shape at a pose.
Volume<2> padded_volume(VolumeKind kind, const Shape<2>& shape, const b2Shape& engine_shape,
                        const b2Transform& transform);

}  // namespace kerf::inline sims2d
