#pragma once

#include <array>
#include <span>

#include "core/geometry/vector.h"

namespace kerf {

/// The principal components of points.
template <int D>
struct PrincipalAxes {
  Vector<D> mean;
  /// Of length one but for rounding, that of the greatest variance first.
  std::array<Vector<D>, D> axes;
};

template <int D>
PrincipalAxes<D> principal_axes(std::span<const Vector<D>> points);

}  // namespace kerf
