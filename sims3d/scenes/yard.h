#pragma once

#include "sims3d/world.h"

namespace kerf {

/// Adds a square floor with its top at y = 0 that reaches from -half to half along X and Z, and a fence
/// around it (none if `fence_height` is 0). Both are bricks about six units long, so that no object is as
/// large as the scene.
void add_yard(OdeWorld& world, Scalar half, Scalar fence_height);

}  // namespace kerf
