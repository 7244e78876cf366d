#pragma once

#include <span>

#include "core/scene/scene.h"

namespace kerf {

/// The area (2D) or volume (3D) of a shape; 0 for a surface, which has no inside.
template <int D>
double size_of(const Shape<D>& shape);

/// The energy of a scene's moving bodies, as a height in units of the scene: (kinetic + potential) over
/// weight, at density 1. Kinetic energy is that of their middles, by their positions a step before; spin is
/// left out. `before` has the positions of the first bodies; newer ones count as at rest.
template <int D>
double energy_height(std::span<const Body<D>> bodies, std::span<const Vector<D>> before);

/// The deepest overlap of two bodies, by the narrow phase on all pairs of boxes; 0 if none touch.
template <int D>
double deepest_penetration(std::span<const Body<D>> bodies);

/// The root of the mean square of the distances of moving bodies from their positions in another run.
template <int D>
double distance_of_runs(std::span<const Body<D>> bodies, std::span<const Vector<D>> others);

}  // namespace kerf
