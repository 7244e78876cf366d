#include "sims2d/scenes/scenes.h"

#include <array>

#include "sims2d/scenes/attractors.h"
#include "sims2d/scenes/buckets.h"
#include "sims2d/scenes/fracture.h"
#include "sims2d/scenes/pile.h"
#include "sims2d/scenes/pyramid.h"
#include "sims2d/scenes/rods.h"
#include "sims2d/scenes/terrain.h"
#include "sims2d/scenes/tumbler.h"

namespace kerf::inline sims2d {

std::span<const SceneEntry<2>> scenes_2d() {
  static const std::array entries{pile_entry(),    terrain_entry(), attractors_entry(), fracture_entry(),
                                  buckets_entry(), pyramid_entry(), tumbler_entry(),    rods_entry()};
  return entries;
}

}  // namespace kerf::inline sims2d
