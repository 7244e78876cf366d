#pragma once

#include <string>

#include "core/bsp/bsp_state.h"

namespace kerf {

/// What keeps a state from being that of a tree between two steps; empty if nothing does. A Bsp that goes on
/// from anything else may crash, or never end.
template <int D>
std::string fault_of(const BspState<D>& state);

}  // namespace kerf
