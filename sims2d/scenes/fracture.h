#pragma once

#include "core/scene/scene.h"

namespace kerf::inline sims2d {

/// The paper's simulation 3 in 2D: building blocks are pulled by one attractor. A block breaks at its first
/// hit into 16 smaller blocks and becomes the first of them.
SceneEntry<2> fracture_entry();

}  // namespace kerf::inline sims2d
