#pragma once

#include <span>

#include "core/geometry/vector.h"

namespace kerf {

/// Sorts finite numbers, ascending. Zeros become positive: the order of two signs would depend on the
/// machine's vectors.
void sort_scalars(std::span<Scalar> scalars);

}  // namespace kerf
