#include "sims2d/scenes/scenes.h"

#include <array>

#include "sims2d/scenes/buckets.h"
#include "sims2d/scenes/pile.h"

namespace kerf::inline sims2d {

std::span<const SceneEntry<2>> scenes_2d() {
  static const std::array entries{pile_entry(), buckets_entry()};
  return entries;
}

}  // namespace kerf::inline sims2d
