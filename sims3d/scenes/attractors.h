#pragma once

#include "core/scene/scene.h"

namespace kerf {

/// The paper's simulation 2 (section 6.2): a chaotic scene without ground in which clouds of objects follow
/// several moving attractors, pass through each other and collide. All objects are there from the first step;
/// none ever rests.
SceneEntry<3> attractors_entry();

}  // namespace kerf
