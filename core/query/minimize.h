#pragma once

#include <functional>

#include "core/query/scenario.h"

namespace kerf {

template <int D>
using Fails = std::function<bool(const Scenario<D>&)>;

/// The last steps of a recording up to `last` with which `fails` still holds, as few as doubling finds.
/// Throws std::runtime_error if it does not hold for all steps either: the recording shows it by decisions
/// about single events, which are no part of a scenario, or not by what happens in it.
template <int D>
Scenario<D> start_late(Replayer<D>& replayer, std::uint32_t last, const Fails<D>& fails);

/// Leaves out objects, steps, and operators in steps while `fails` holds, until none of them can be left out
/// alone. Throws std::runtime_error if it does not hold for what is left, where it is asked once more.
///
/// Pre: fails(scenario).
template <int D>
Scenario<D> minimize(Scenario<D> scenario, const Fails<D>& fails);

}  // namespace kerf
