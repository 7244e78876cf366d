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

/// A bound moved by a margin as far as an engine that counts in `Number` may move it, but never by more than
/// twice the margin unless the nearest number is so far. Such an engine rounds the margin, and on the way
/// from bounds to extent, centre and half extents numbers up to `reach`, whose last places may be much larger
/// than those of the result.
template <class Number>
double moved_by(double from, double by, double reach) {
  using Limits = std::numeric_limits<Number>;
  constexpr double kUnit = static_cast<double>(Limits::epsilon());
  const auto rounded = [](double x) {
    constexpr double kMost = static_cast<double>(Limits::max());
    return static_cast<Number>(std::clamp(x, -kMost, kMost));
  };
  const auto is_near = [=](Number x) { return std::abs(static_cast<double>(x) - from) <= 2 * std::abs(by); };
  const double exact = from + by * (1 + 2 * kUnit);
  const Number nearest = rounded(exact);
  Number further = rounded(exact + std::copysign(2 * kUnit * (reach + std::abs(by)), by));
  if (!is_near(further)) further = std::nextafter(nearest, by < 0 ? Limits::lowest() : Limits::max());
  return static_cast<double>(is_near(further) ? further : nearest);
}

/// The box with a margin, of an engine that counts in `Number`. Without a margin it stays as it is; a share
/// of an extent that has no end is none.
template <class Number = double, int D>
GivenBox<D> grow(GivenBox<D> box, const Margin& margin) {
  if (margin == Margin{}) return box;
  for (std::size_t i = 0; i < D; ++i) {
    const double extent = box.max[i] - box.min[i];
    const bool is_finite = std::isfinite(extent);
    const double by = margin.absolute + (is_finite ? margin.share * extent : 0);
    const double reach = is_finite ? std::max({std::abs(box.min[i]), std::abs(box.max[i]), extent}) : 0;
    box.min[i] = moved_by<Number>(box.min[i], -by, reach);
    box.max[i] = moved_by<Number>(box.max[i], by, reach);
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
