#pragma once

#include <string>

#include "core/bsp/bsp_state.h"

namespace kerf {

/// The reason why a state cannot be that of a tree between two steps; empty if it can. A Bsp that continues
/// from an impossible state may crash, or never end.
template <int D>
std::string fault_of(const BspState<D>& state);

}  // namespace kerf
