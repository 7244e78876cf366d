#pragma once

#include "core/scene/scene.h"

namespace kerf::inline sims2d {

/// Long thin rods come to rest on a slope of 45 degrees that ends at another one. Along the axes their boxes
/// are large and overlap many others; oriented boxes and partitioners in free directions separate them.
SceneEntry<2> rods_entry();

}  // namespace kerf::inline sims2d
