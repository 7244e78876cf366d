#pragma once

#include "core/scene/scene.h"

namespace kerf::inline sims2d {

/// A pyramid of equal blocks that stands, and a disc that falls onto its top: the stack on which solvers are
/// judged. Boxes touch everywhere and hardly move.
SceneEntry<2> pyramid_entry();

}  // namespace kerf::inline sims2d
