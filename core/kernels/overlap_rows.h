#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/base/ids.h"
#include "core/kernels/wide_block.h"

namespace kerf {

/// Words of 64 bits in which the boxes of so many blocks have a bit each.
constexpr std::size_t words_of_row(std::size_t blocks) { return (blocks * kBlockWidth + 63) / 64; }

/// Writes a row of bits for each of the objects: whether its box overlaps the others, and itself, in the
/// closed sense. The box of an object is in the slot of its id. `only_later`: of each row only the bits from
/// the object's own on are asked for, and those before them may be anything.
template <int D>
void overlap_rows(std::span<const WideBlock<D>> boxes, std::span<const ObjectId> objects, bool only_later,
                  std::uint64_t* rows);

}  // namespace kerf
