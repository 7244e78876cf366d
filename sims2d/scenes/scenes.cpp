#include "sims2d/scenes/scenes.h"

#include <array>

#include "sims2d/scenes/scene_entries.h"

namespace kerf::inline sims2d {

std::span<const SceneEntry<2>> scenes_2d() {
  static const std::array entries{pile_entry(),    terrain_entry(), attractors_entry(), fracture_entry(),
                                  buckets_entry(), pyramid_entry(), tumbler_entry(),    rods_entry()};
  return entries;
}

}  // namespace kerf::inline sims2d
