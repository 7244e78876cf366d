#pragma once

#include "core/trace/statistics.h"
#include "core/tree/scheduler.h"
#include "core/tree/tree.h"

namespace kerf {

/// What a tree is like at any moment of a step, and what its scheduler has done: all but what a whole step
/// adds, which are `placed` and `phase_seconds`.
template <int D>
Statistics statistics_of(const Tree<D>& tree, const Scheduler<D>& scheduler);

}  // namespace kerf
