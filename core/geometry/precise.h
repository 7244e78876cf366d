#pragma once

#include <array>
#include <cstddef>

#include "core/geometry/vector.h"

namespace kerf {

/// A point or direction of D doubles, for sums that floats would round too much.
template <int D>
using Precise = std::array<double, D>;

template <int D>
Precise<D> to_precise(const Scalar* first) {
  Precise<D> p;
  for (std::size_t i = 0; i < D; ++i) p[i] = static_cast<double>(first[i]);
  return p;
}

template <int D>
Precise<D> to_precise(const Vector<D>& v) {
  return to_precise<D>(v.value.data());
}

/// The inner product, summed in the order of the axes.
template <int D>
double inner(const Precise<D>& a, const Precise<D>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < D; ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace kerf
