#pragma once

#include <memory>

#include "frames/rivals/rival.h"

namespace kerf {

/// Embree's rtcCollide on one thread: a tree of user primitives, built anew when boxes change. Moving and
/// fixed objects have a scene each.
std::unique_ptr<BroadPhase<3>> make_embree(const RivalHints<3>& hints, Intake intake);

}  // namespace kerf
