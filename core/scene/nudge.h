#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "core/geometry/vector.h"

namespace kerf {

/// The point moved by so many ulps along its first axis: the smallest change of a scene, to measure how
/// chaotic it is.
template <int D>
Vector<D> nudged(Vector<D> point, std::uint32_t ulps) {
  for (; ulps > 0; --ulps) point[0] = std::nextafter(point[0], std::numeric_limits<Scalar>::max());
  return point;
}

}  // namespace kerf
