#pragma once

#include <memory>

#include "frames/rivals/rival.h"

namespace kerf {

/// btDbvtBroadphase: two dynamic trees of fat boxes and a hashed cache of pairs.
std::unique_ptr<BroadPhase<3>> make_bullet_dbvt(const RivalHints<3>& hints, Intake intake);
/// bt32BitAxisSweep3: three sorted lists of ends, quantised to 32 bits over the bounds.
std::unique_ptr<BroadPhase<3>> make_bullet_axis_sweep(const RivalHints<3>& hints, Intake intake);

}  // namespace kerf
