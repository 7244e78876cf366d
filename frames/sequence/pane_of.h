#pragma once

#include <optional>
#include <span>
#include <string>

#include "core/objects/broad_phase.h"
#include "viz/draw/panes.h"

namespace kerf {

/// The pane of a broad phase after a step. `bounds`: where cells without ends are measured. `milliseconds`:
/// none if its steps are not timed.
template <int D>
StructurePane<D> pane_of(const std::string& name, const BroadPhase<D>& broad_phase,
                         std::span<const Body<D>> bodies, const Box<D>& bounds,
                         std::optional<double> milliseconds);

}  // namespace kerf
