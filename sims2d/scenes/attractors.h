#pragma once

#include "core/scene/scene.h"

namespace kerf::inline sims2d {

/// The paper's simulation 2 in 2D: clouds of objects follow several moving attractors, without gravity, and
/// pass through each other. All objects are there from the first step; none ever rests.
SceneEntry<2> attractors_entry();

}  // namespace kerf::inline sims2d
