#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/ids.h"
#include "core/geometry/vector.h"

namespace kerf {

/// Boxes by columns: all minima along the first axis, then along the others, then all maxima.
struct BoxColumns {
  static constexpr std::size_t kStep = 8;  ///< boxes are compared so many at a time
  const Scalar* numbers = nullptr;
  std::size_t stride = 0;  ///< from a column to the next; a multiple of kStep
};

/// Writes a row of bits for each of these boxes: whether it overlaps the others, and itself, in the closed
/// sense. A row has a word for each 64 boxes, and no bit behind the stride.
template <int D>
void overlap_rows(const BoxColumns& boxes, const ObjectId* objects, std::size_t count, std::uint64_t* rows);

}  // namespace kerf
