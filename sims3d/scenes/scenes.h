#pragma once

#include <span>

#include "core/scene/scene.h"

namespace kerf {

/// The 3D scenes. Their `make` throws std::invalid_argument for more objects or steps than they can take, and
/// takes a broad phase that is empty.
std::span<const SceneEntry<3>> scenes_3d();

}  // namespace kerf
