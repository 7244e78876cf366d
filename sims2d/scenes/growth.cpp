#include "sims2d/scenes/growth.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace kerf::inline sims2d {

std::uint32_t Growth::due(std::uint32_t step) const {
  const std::uint64_t part = std::min(step, steps);
  return static_cast<std::uint32_t>(part * objects / steps);
}

Growth growth_of(const SceneOptions& options, std::uint32_t default_objects) {
  if (options.objects > kMaxObjects2d)
    throw std::invalid_argument(std::to_string(options.objects) + " objects are too many: at most " +
                                std::to_string(kMaxObjects2d) + " are possible");
  Growth growth;
  growth.objects = options.objects == 0 ? default_objects : options.objects;
  // Scenes are as wide as the square root of their objects, and so is the band from which objects fall.
  const auto dense =
      static_cast<std::uint32_t>(std::ceil(20 * std::sqrt(static_cast<double>(growth.objects))));
  growth.steps = options.steps == 0 ? dense : options.steps;
  growth.recycle = options.recycle;
  growth.nudge = options.nudge;
  return growth;
}

}  // namespace kerf::inline sims2d
