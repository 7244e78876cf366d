#pragma once

#include <cstdint>
#include <memory>

#include "frames/bench/motion.h"
#include "frames/bench/random/random_scene.h"

namespace kerf {

/// The motion of a random scene of this dimension. Beside its objects there are others that are absent at
/// first if objects go and come. Its bounds hold all objects at first and in `steps` steps.
template <int D>
std::unique_ptr<Motion<D>> make_random_motion(const RandomScene& scene, std::uint32_t steps = 0);

}  // namespace kerf
