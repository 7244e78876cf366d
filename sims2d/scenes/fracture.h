#pragma once

#include "core/scene/scene.h"

namespace kerf::inline sims2d {

/// The paper's simulation 3 in 2D: building blocks are pulled by one attractor; what is hit for the first
/// time breaks into 16 smaller blocks, of which it becomes the first itself.
SceneEntry<2> fracture_entry();

}  // namespace kerf::inline sims2d
