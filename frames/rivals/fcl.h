#pragma once

#include <memory>

#include "frames/rivals/rival.h"

namespace kerf {

/// The managers of the Flexible Collision Library, which hold the boxes in doubles.
std::unique_ptr<BroadPhase<3>> make_fcl_dynamic_tree(const RivalHints<3>& hints, Intake intake);
std::unique_ptr<BroadPhase<3>> make_fcl_sweep_and_prune(const RivalHints<3>& hints, Intake intake);
std::unique_ptr<BroadPhase<3>> make_fcl_interval_tree(const RivalHints<3>& hints, Intake intake);
std::unique_ptr<BroadPhase<3>> make_fcl_spatial_hash(const RivalHints<3>& hints, Intake intake);

}  // namespace kerf
