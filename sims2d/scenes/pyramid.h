#pragma once

#include "core/scene/scene.h"

namespace kerf::inline sims2d {

/// A standing pyramid of equal blocks, and a disc that falls onto its top: the stack by which solvers are
/// judged. Boxes touch everywhere and hardly move.
SceneEntry<2> pyramid_entry();

}  // namespace kerf::inline sims2d
