#pragma once

#include "core/scene/scene.h"

namespace kerf {

/// The paper's simulation 3 (section 6.2): a few building blocks are pulled by one attractor. A block breaks
/// at its first hit into 27 smaller blocks and becomes the first of them, so that no object ever goes.
SceneEntry<3> fracture_entry();

}  // namespace kerf
