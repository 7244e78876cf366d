#pragma once

#include <span>

#include "core/scene/scene.h"

namespace kerf::inline sims2d {

/// Every 2D scene. `make` throws std::invalid_argument for options that it cannot serve.
std::span<const SceneEntry<2>> scenes_2d();

}  // namespace kerf::inline sims2d
