#pragma once

#include "core/scene/scene.h"

namespace kerf {

/// The paper's simulation 3 (section 6.2): a few building blocks are pulled by one attractor; what is hit for
/// the first time breaks into 27 smaller blocks. A block becomes its own first fragment, so that no object
/// ever goes.
SceneEntry<3> fracture_entry();

}  // namespace kerf
