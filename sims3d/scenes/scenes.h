#pragma once

#include <span>

#include "core/scene/scene.h"

namespace kerf {

/// The 3D scenes. Their `make` takes an empty broad phase, and throws std::invalid_argument for more objects
/// or steps than they support.
std::span<const SceneEntry<3>> scenes_3d();

}  // namespace kerf
