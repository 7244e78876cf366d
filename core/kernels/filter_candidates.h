#pragma once

#include <span>
#include <vector>

#include "core/base/append_buffer.h"
#include "core/kernels/kept_leaf.h"

namespace kerf {

/// Appends those of the candidates whose boxes overlap. `boxes` is by object; `gathered` is room for those of
/// the leaf. If candidates are named by places, each box is read from the table only once.
template <int D>
void filter_candidates(const KeptLeaf<D>& leaf, std::span<const PackedBox<D>> boxes,
                       std::vector<PackedBox<D>>& gathered, PairBuffer& pairs);

}  // namespace kerf
