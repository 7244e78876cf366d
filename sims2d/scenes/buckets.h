#pragma once

#include "core/scene/scene.h"

namespace kerf::inline sims2d {

/// Objects fall into a row of buckets with slanted walls. Objects that miss them or spill over stay in the
/// yard.
SceneEntry<2> buckets_entry();

}  // namespace kerf::inline sims2d
