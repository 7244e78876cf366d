#pragma once

#include <cstdint>
#include <span>

#include "core/base/ids.h"
#include "core/kernels/wide_block.h"

namespace kerf {

/// Writes a row of bits for each of the objects: whether its box overlaps the others, and itself, in the
/// closed sense. The box of an object is in the slot of its id. A row has a word for each eight blocks.
template <int D>
void overlap_rows(std::span<const WideBlock<D>> boxes, std::span<const ObjectId> objects,
                  std::uint64_t* rows);

}  // namespace kerf
