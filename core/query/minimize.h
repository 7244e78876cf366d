#pragma once

#include <functional>

#include "core/query/scenario.h"

namespace kerf {

/// Makes a scenario smaller while `fails(scenario)` holds: fewer steps before the failure, fewer objects,
/// fewer steps between, until none of them can be left out alone. `steps` first, since every trial runs what
/// is left.
///
/// Pre: fails(scenario).
template <int D>
Scenario<D> minimize(Scenario<D> scenario, const std::function<bool(const Scenario<D>&)>& fails);

}  // namespace kerf
