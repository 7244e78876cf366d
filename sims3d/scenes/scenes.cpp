#include "sims3d/scenes/scenes.h"

#include <array>

#include "sims3d/scenes/attractors.h"
#include "sims3d/scenes/buckets.h"
#include "sims3d/scenes/fracture.h"
#include "sims3d/scenes/jelly.h"
#include "sims3d/scenes/projectile.h"
#include "sims3d/scenes/rods.h"
#include "sims3d/scenes/terrain.h"

namespace kerf {

std::span<const SceneEntry<3>> scenes_3d() {
  static const std::array entries{terrain_entry(),    attractors_entry(),    fracture_entry(),
                                  buckets_entry(),    awake_buckets_entry(), rods_entry(),
                                  projectile_entry(), jelly_entry()};
  return entries;
}

}  // namespace kerf
