#pragma once

#include "core/scene/scene.h"

namespace kerf::inline sims2d {

/// The paper's simulation 1 in 2D: discs, rectangles and polygons fall onto hills made of many fixed columns.
/// Their number grows.
SceneEntry<2> terrain_entry();

}  // namespace kerf::inline sims2d
