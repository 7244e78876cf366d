#pragma once

#include <algorithm>
#include <limits>

#include "core/base/float_mode.h"
#include "core/geometry/box.h"
#include "core/world/object_def.h"
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

/// The fat box of an object: it holds the box, and is the box if there is no margin.
template <int D>
Box<D> grow(Box<D> box, Scalar margin) {
  if (!is_thick(margin)) return box;
  const DefaultFloats floats;
  for (int i = 0; i < D; ++i) {
    box.min[i] -= margin;
    box.max[i] += margin;
  }
  (void)clamp(box);
  return box;
}

template <int D>
Box<D> shifted(const Box<D>& box, const Vector<D>& by) {
  Box<D> result;
  for (int i = 0; i < D; ++i) {
    result.min[i] = box.min[i] + by[i];
    result.max[i] = box.max[i] + by[i];
  }
  return result;
}

}  // namespace kerf
