#pragma once

#include "core/scene/scene.h"

namespace kerf::inline sims2d {

/// Discs, rectangles and polygons fall into a heap between two walls, past two slanted boards.
SceneEntry<2> pile_entry();

}  // namespace kerf::inline sims2d
