#pragma once

#include <algorithm>
#include <limits>

#include "core/geometry/box.h"
#include "core/world/world_status.h"

namespace kerf {

/// Whether a world takes the box: without NaN, and no minimum above its maximum.
template <int D>
constexpr bool is_ordered(const Box<D>& box) {
  bool all = true;
  for (int i = 0; i < D; ++i) all &= box.min[i] <= box.max[i];  // false for NaN
  return all;
}

/// Makes the bounds finite.
template <int D>
WorldStatus clamp(Box<D>& box) {
  if (is_valid(box)) return WorldStatus::ok;
  constexpr Scalar kMax = std::numeric_limits<Scalar>::max();
  for (int i = 0; i < D; ++i) {
    box.min[i] = std::clamp(box.min[i], -kMax, kMax);
    box.max[i] = std::clamp(box.max[i], -kMax, kMax);
  }
  return WorldStatus::clamped;
}

/// The fat box of an object with a margin.
template <int D>
Box<D> grow(Box<D> box, Scalar margin) {
  for (int i = 0; i < D; ++i) {
    box.min[i] -= margin;
    box.max[i] += margin;
  }
  (void)clamp(box);
  return box;
}

template <int D>
Box<D> shifted(const Box<D>& box, const Vector<D>& by) {
  return {box.min + by, box.max + by};
}

}  // namespace kerf
