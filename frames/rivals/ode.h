#pragma once

#include <memory>

#include "frames/rivals/rival.h"

namespace kerf {

/// ODE's spaces, as in sims3d/.
std::unique_ptr<BroadPhase<3>> make_ode_hash(const RivalHints<3>& hints, Intake intake);
std::unique_ptr<BroadPhase<3>> make_ode_quadtree(const RivalHints<3>& hints, Intake intake);
std::unique_ptr<BroadPhase<3>> make_ode_sweep_and_prune(const RivalHints<3>& hints, Intake intake);

}  // namespace kerf
