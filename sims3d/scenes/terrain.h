#pragma once

#include "core/scene/scene.h"

namespace kerf {

/// The paper's simulation 1 (section 6.2): spheres and blocks fall into a terrain; their number grows. The
/// terrain is a square of at least 16 by 16 tiles, each a mesh and an object of its own that never moves; a
/// rim keeps everything inside. Its area grows with the number of objects.
SceneEntry<3> terrain_entry();

}  // namespace kerf
