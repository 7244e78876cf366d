#pragma once

#include <cstddef>

#include "core/geometry/box.h"

namespace kerf {

// Boxes as rows of numbers: D lower ends, then D upper ones.

/// Whether all rows are boxes: no end is NaN, and no lower one is above its upper one.
template <int D>
bool are_boxes(const float* rows, std::size_t count);
template <int D>
bool are_boxes(const double* rows, std::size_t count);

/// The same, and each row becomes the smallest box of floats around it, with infinite ends where it is beyond
/// the range of floats. If some row is no box, anything is written.
template <int D>
bool round_boxes(const double* rows, std::size_t count, Box<D>* boxes);

}  // namespace kerf
