#pragma once

#include "core/bsp/bsp_state.h"
#include "core/query/common_numbers.h"

namespace kerf {

/// Whether two trees are the same but for the numbers of their objects: what Bsp::state_hash hashes, by the
/// common numbers. Objects that are not there make no difference.
template <int D>
bool same_trees(const BspState<D>& a, const BspState<D>& b, CommonNumbers& numbers);

}  // namespace kerf
