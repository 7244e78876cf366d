#pragma once

#include "core/scene/scene.h"

namespace kerf {

/// A heavy ball is shot through a stack of blocks at rest, 1.8 units a step; every 100 steps it comes anew,
/// from the other side. One box that jumps by more than its neighbours' size, and bursts of motion in a scene
/// at rest.
SceneEntry<3> projectile_entry();

}  // namespace kerf
