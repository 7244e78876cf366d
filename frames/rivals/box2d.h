#pragma once

#include <memory>

#include "frames/rivals/rival.h"

namespace kerf {

/// b2DynamicTree, queried for the neighbours of every moving object in each step.
std::unique_ptr<BroadPhase<2>> make_box2d_tree(const RivalHints<2>& hints, Intake intake);
/// b2BroadPhase, which reports new pairs of fat boxes; they are kept as Box2D's contact manager keeps them.
std::unique_ptr<BroadPhase<2>> make_box2d_broad_phase(const RivalHints<2>& hints, Intake intake);

}  // namespace kerf
