#pragma once

#include <array>

#include "core/geometry/volume.h"
#include "core/scene/shape.h"

namespace kerf {

/// A pose in doubles, as engines keep it.
template <int D>
struct PrecisePose {
  std::array<double, D> position{};
  std::array<std::array<double, D>, D> axes{};  ///< where the body's axes point, orthonormal
};

/// The pose that a scene shows, in doubles.
template <int D>
PrecisePose<D> precise(const Pose<D>& pose);

/// A volume of the given kind that holds the shape at that pose and `margin` (>= 0) around it, all rounded
/// outward: no contact falls between the engine's doubles and our floats (DESIGN.md, "Borders").
template <int D>
Volume<D> bound(VolumeKind kind, const Shape<D>& shape, const PrecisePose<D>& pose, double margin = 0);

}  // namespace kerf
