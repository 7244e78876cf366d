#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/geometry/box.h"

namespace kerf {

/// A box in doubles, as another engine gave it. Closed on every side.
template <int D>
struct GivenBox {
  std::array<double, D> min{};
  std::array<double, D> max{};
  friend bool operator==(const GivenBox&, const GivenBox&) = default;
};

/// How much larger than given an engine makes its boxes on each side: so much, and a share of their extent.
struct Margin {
  double absolute = 0;
  double share = 0;
  friend bool operator==(const Margin&, const Margin&) = default;
};

template <int D>
GivenBox<D> to_given(const Box<D>& box) {
  GivenBox<D> given;
  for (int i = 0; i < D; ++i) {
    given.min[static_cast<std::size_t>(i)] = static_cast<double>(box.min[i]);
    given.max[static_cast<std::size_t>(i)] = static_cast<double>(box.max[i]);
  }
  return given;
}

/// The smallest box of floats around it. An interval that is inverted stays so, and NaN stays NaN.
template <int D>
Box<D> round_outward(const GivenBox<D>& given) {
  Box<D> box;
  for (int i = 0; i < D; ++i) {
    const double min = given.min[static_cast<std::size_t>(i)];
    const double max = given.max[static_cast<std::size_t>(i)];
    box.min[i] = min > max ? round_up(min) : round_down(min);
    box.max[i] = min > max ? round_down(max) : round_up(max);
    if (min > max && box.min[i] == box.max[i])
      box.max[i] = std::nextafter(box.max[i], -std::numeric_limits<Scalar>::infinity());
  }
  return box;
}

/// Closed-interval overlap on every axis, as of boxes in floats.
template <int D>
constexpr bool overlaps(const GivenBox<D>& a, const GivenBox<D>& b) {
  bool all = true;
  for (std::size_t i = 0; i < D; ++i) all &= (a.min[i] <= b.max[i]) & (b.min[i] <= a.max[i]);
  return all;
}

/// A bound moved by a margin as far as an engine that counts in `Number` may move it: to the nearest number,
/// or one further, but never by twice the margin. The margin is rounded by such an engine, too.
template <class Number>
double moved_by(double from, double by) {
  using Limits = std::numeric_limits<Number>;
  const double most = static_cast<double>(Limits::max());
  const double exact = from + by * (1 + 2 * static_cast<double>(Limits::epsilon()));
  const auto nearest = static_cast<Number>(std::clamp(exact, -most, most));
  const auto further = std::nextafter(nearest, by < 0 ? Limits::lowest() : Limits::max());
  return static_cast<double>(std::abs(further - from) <= 2 * std::abs(by) ? further : nearest);
}

/// The box with a margin, of an engine that counts in `Number`. Without a margin it stays as it is; a share
/// of an extent that has no end is none.
template <class Number = double, int D>
GivenBox<D> grow(GivenBox<D> box, const Margin& margin) {
  if (margin == Margin{}) return box;
  for (std::size_t i = 0; i < D; ++i) {
    const double extent = box.max[i] - box.min[i];
    const double by = margin.absolute + (std::isfinite(extent) ? margin.share * extent : 0);
    box.min[i] = moved_by<Number>(box.min[i], -by);
    box.max[i] = moved_by<Number>(box.max[i], by);
  }
  return box;
}

/// The smallest box that holds both; NaN if one has it.
template <int D>
GivenBox<D> join(GivenBox<D> a, const GivenBox<D>& b) {
  for (std::size_t i = 0; i < D; ++i) {
    if (b.min[i] < a.min[i] || std::isnan(b.min[i])) a.min[i] = b.min[i];
    if (b.max[i] > a.max[i] || std::isnan(b.max[i])) a.max[i] = b.max[i];
  }
  return a;
}

}  // namespace kerf
