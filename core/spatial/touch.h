#pragma once

#include "core/geometry/box.h"
#include "core/spatial/query.h"

namespace kerf {

// The definitions of what queries find: in real arithmetic on the given floats, closed. What a box touches,
// every box around it touches, too. The queries are valid (`check`), and so is the box. The processor rounds
// to nearest (NearestRounding), and whether it takes denormals for zero changes only what a region touches
// that is a box (UsualComparisons) and the t of a hit.

template <int D>
constexpr bool touches(const Box<D>& region, const Box<D>& box) {
  return overlaps(region, box);
}
template <int D>
bool touches(const Sphere<D>& sphere, const Box<D>& box);
template <int D>
bool touches(const Frustum<D>& frustum, const Box<D>& box);
template <int D>
bool touches(const Cast<D>& cast, const Box<D>& box);

/// The t of a hit, given that the cast touches the box: 0 or the largest of the axes' quotients, in doubles,
/// then rounded; the largest float if it is larger.
template <int D>
Scalar entry_of(const Cast<D>& cast, const Box<D>& box);

/// The square of the distance between a point and a box, in doubles.
template <int D>
double squared_distance(const Vector<D>& point, const Box<D>& box);

}  // namespace kerf
