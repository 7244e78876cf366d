#pragma once

#include "core/scene/scene.h"

namespace kerf::inline sims2d {

/// A square drum turns and tumbles its contents. Its four walls are moving objects as long as the scene is
/// wide, at an angle most of the time.
SceneEntry<2> tumbler_entry();

}  // namespace kerf::inline sims2d
