#pragma once

#include "core/scene/scene.h"

namespace kerf {

/// The paper's simulation 4 (section 6.2): balls and bricks fall into open buckets, which stand in a square
/// on the XZ plane, and pile up there. There are enough buckets for piles about three units deep. Each bucket
/// is a floor tile and four walls, all separate bricks that never move; a low fence closes the square.
SceneEntry<3> buckets_entry();

/// The same without sleep: the cost of a broad phase when piles never come to rest.
SceneEntry<3> awake_buckets_entry();

}  // namespace kerf
