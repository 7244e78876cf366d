#include "sims3d/scenes/scenes.h"

#include <array>

#include "sims3d/scenes/scene_entries.h"

namespace kerf {

std::span<const SceneEntry<3>> scenes_3d() {
  static const std::array entries{terrain_entry(),    attractors_entry(),    fracture_entry(),
                                  buckets_entry(),    awake_buckets_entry(), rods_entry(),
                                  projectile_entry(), jelly_entry()};
  return entries;
}

}  // namespace kerf
