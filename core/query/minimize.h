#pragma once

#include <functional>

#include "core/query/scenario.h"

namespace kerf {

template <int D>
using Fails = std::function<bool(const Scenario<D>&)>;

/// The last steps of a recording up to `last` with which `fails` still holds, as few as doubling finds.
///
/// Pre: it holds for all steps up to `last`.
template <int D>
Scenario<D> start_late(Replayer<D>& replayer, std::uint32_t last, const Fails<D>& fails);

/// Leaves out objects, steps, and operators in steps while `fails` holds, until none of them can be left out
/// alone.
///
/// Pre: fails(scenario).
template <int D>
Scenario<D> minimize(Scenario<D> scenario, const Fails<D>& fails);

}  // namespace kerf
