#pragma once

#include "core/scene/scene.h"

namespace kerf {

/// Long thin rods, nearly parallel to a diagonal of the floor, fall onto it in layers and come to rest as a
/// bed of logs. Along the axes their boxes are large and overlap many others; oriented boxes and partitioners
/// in free directions separate them.
SceneEntry<3> rods_entry();

}  // namespace kerf
