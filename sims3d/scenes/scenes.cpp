#include "sims3d/scenes/scenes.h"

#include <array>

#include "sims3d/scenes/buckets.h"
#include "sims3d/scenes/terrain.h"

namespace kerf {

std::span<const SceneEntry<3>> scenes_3d() {
  static const std::array entries{terrain_entry(), buckets_entry(), awake_buckets_entry()};
  return entries;
}

}  // namespace kerf
