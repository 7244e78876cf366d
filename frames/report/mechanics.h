#pragma once

#include <span>
#include <vector>

#include "core/scene/scene.h"

namespace kerf {

/// The area (2D) or volume (3D) of a shape; 0 for a surface, which has no inside.
template <int D>
double size_of(const Shape<D>& shape);

/// What a scene's moving bodies have of energy, as a height in units of the scene: (kinetic + potential) over
/// weight, at density 1. Kinetic is that of their middles, from where they were a step before; spin is left
/// out. `before` holds positions of the first bodies; those that came since count as at rest.
template <int D>
double energy_height(std::span<const Body<D>> bodies, std::span<const Vector<D>> before);

/// The deepest that two bodies are in each other, by the narrow phase on all pairs of boxes; 0 if none touch.
template <int D>
double deepest_penetration(std::span<const Body<D>> bodies);

/// The root of the mean square of how far moving bodies are from where they are in another run.
template <int D>
double distance_of_runs(std::span<const Body<D>> bodies, std::span<const Vector<D>> others);

}  // namespace kerf
