#pragma once

#include <memory>

#include "frames/rivals/rival.h"

namespace kerf {

/// CGAL::box_self_intersection_d, which builds its segment trees anew each time, with closed boxes.
template <int D>
std::unique_ptr<BroadPhase<D>> make_cgal(const RivalHints<D>& hints, Intake intake);

}  // namespace kerf
