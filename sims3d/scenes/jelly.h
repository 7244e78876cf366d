#pragma once

#include "core/scene/scene.h"

namespace kerf {

/// Soft blocks tumble into a basin: the paper's announced extension to deformable objects (section 7). Each
/// block breathes, and wobbles after every knock: its extents follow damped springs while its volume stays,
/// so that every box changes its size in every step.
SceneEntry<3> jelly_entry();

}  // namespace kerf
