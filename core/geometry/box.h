#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/vector.h"

namespace kerf {

/// An axis-aligned box, closed on every side: touching boxes overlap.
template <int D>
struct Box {
  Vector<D> min;
  Vector<D> max;

  /// The box that holds nothing: joining it with a box gives that box.
  static constexpr Box empty() {
    Box box;
    for (int i = 0; i < D; ++i) {
      box.min[i] = std::numeric_limits<Scalar>::max();
      box.max[i] = std::numeric_limits<Scalar>::lowest();
    }
    return box;
  }

  [[nodiscard]] constexpr Vector<D> center() const { return min * 0.5F + max * 0.5F; }
  [[nodiscard]] constexpr Vector<D> extent() const { return max - min; }
  friend constexpr bool operator==(const Box&, const Box&) = default;
};

/// Closed-interval overlap on every axis: the definition of a pair.
template <int D>
constexpr bool overlaps(const Box<D>& a, const Box<D>& b) {
  bool all = true;
  for (int i = 0; i < D; ++i) all &= (a.min[i] <= b.max[i]) & (b.min[i] <= a.max[i]);
  return all;
}

template <int D>
constexpr bool contains(const Box<D>& outer, const Box<D>& inner) {
  bool all = true;
  for (int i = 0; i < D; ++i) all &= (outer.min[i] <= inner.min[i]) & (inner.max[i] <= outer.max[i]);
  return all;
}

/// The smallest box that holds both.
template <int D>
constexpr Box<D> join(Box<D> a, const Box<D>& b) {
  for (int i = 0; i < D; ++i) {
    a.min[i] = std::min(a.min[i], b.min[i]);
    a.max[i] = std::max(a.max[i], b.max[i]);
  }
  return a;
}

/// A box that can be placed as it is: min <= max on each axis and every bound finite. False for NaN.
template <int D>
constexpr bool is_valid(const Box<D>& box) {
  constexpr Scalar kMax = std::numeric_limits<Scalar>::max();
  bool all = true;
  for (int i = 0; i < D; ++i)
    all &= (box.min[i] <= box.max[i]) & (box.min[i] >= -kMax) & (box.max[i] <= kMax);
  return all;
}

/// A double rounded to the float at or below it, kept within the finite range.
inline Scalar round_down(double x) {
  constexpr double kMax = std::numeric_limits<Scalar>::max();
  if (std::isnan(x)) return std::numeric_limits<Scalar>::quiet_NaN();
  if (x > kMax) return std::numeric_limits<Scalar>::max();
  if (x < -kMax) return std::numeric_limits<Scalar>::lowest();
  const auto f = static_cast<Scalar>(x);
  return static_cast<double>(f) > x ? std::nextafter(f, std::numeric_limits<Scalar>::lowest()) : f;
}

/// A double rounded to the float at or above it, kept within the finite range.
inline Scalar round_up(double x) { return -round_down(-x); }

}  // namespace kerf
