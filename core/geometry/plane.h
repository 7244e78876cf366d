#pragma once

#include <cstdint>

#include "core/geometry/box.h"
#include "core/geometry/vector.h"

namespace kerf {

/// The projection of an object onto a direction, closed on both sides.
struct Interval {
  Scalar lo = 0;
  Scalar hi = 0;
  friend constexpr bool operator==(const Interval&, const Interval&) = default;
};

/// Where a whole object lies relative to a partitioner. It is on at least one side.
struct Sides {
  bool left = false;
  bool right = false;
  [[nodiscard]] constexpr bool straddle() const { return left && right; }
  friend constexpr bool operator==(const Sides&, const Sides&) = default;
};

/// A partitioner: direction n and offset d. Components of the normal lie in [-1, 1]; it need not have
/// length one.
template <int D>
struct Plane {
  Vector<D> normal;
  Scalar offset = 0;
  friend constexpr bool operator==(const Plane&, const Plane&) = default;
};

/// Projects a box with its own corners, chosen per axis by the sign of the normal. Two boxes that overlap
/// have overlapping intervals for every direction, without any epsilon (DESIGN.md, "Classification").
template <int D>
constexpr Interval project(const Vector<D>& normal, const Box<D>& box) {
  Vector<D> low = box.min;
  Vector<D> high = box.max;
  for (int i = 0; i < D; ++i) {
    if (normal[i] < 0) {
      low[i] = box.max[i];
      high[i] = box.min[i];
    }
  }
  return {dot(normal, low), dot(normal, high)};
}

/// The same for a normal that is number `direction` of a set: the first D are the axes, where the
/// projection's ends are the box's own.
template <int D>
constexpr Interval project(std::uint32_t direction, const Vector<D>& normal, const Box<D>& box) {
  const int axis = static_cast<int>(direction);
  return direction < D ? Interval{box.min[axis], box.max[axis]} : project(normal, box);
}

/// Left iff lo <= d, right iff hi > d: two objects with overlapping intervals share a side.
constexpr Sides classify(const Interval& interval, Scalar offset) {
  return {interval.lo <= offset, interval.hi > offset};
}

}  // namespace kerf
