#pragma once

#include "core/bsp/leaf_boxes.h"
#include "core/bsp/step_context.h"

namespace kerf {

/// Whether most objects may still lie in their leaf's cell: few come or go, and most did not jump, or the
/// partitioners came along. Call it before the tree's table gets the latest boxes. A mistake costs time.
template <int D>
bool may_stay(const StepContext<D>& step);

/// Places all objects by the boxes of the tree's table. `many_stay`, as `may_stay` said of this step: those
/// that do not lie in their leaf's cell are looked for first, and only they are placed anew. If boxes are
/// wanted, `boxes` has those of all leaves afterwards.
template <int D>
void place_boxes(const StepContext<D>& step, bool many_stay, LeafBoxes<D>& boxes);

}  // namespace kerf
