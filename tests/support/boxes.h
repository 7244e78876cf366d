#pragma once

#include "core/base/random.h"
#include "core/geometry/box.h"

namespace kerf::test {

template <int D>
Vector<D> all(Scalar x) {
  Vector<D> v;
  for (int i = 0; i < D; ++i) v[i] = x;
  return v;
}

/// The box that reaches `half` from `center` on every axis.
template <int D>
Box<D> box_at(const Vector<D>& center, Scalar half) {
  return {center - all<D>(half), center + all<D>(half)};
}

/// A box from `low` to `high` along `axis` and from 0 to 1 along the others.
template <int D>
Box<D> slab(Scalar low, Scalar high, int axis = 0) {
  Box<D> box{all<D>(0), all<D>(1)};
  box.min[axis] = low;
  box.max[axis] = high;
  return box;
}

template <int D>
Vector<D> random_point(Random& random, double low, double high) {
  Vector<D> v;
  for (int i = 0; i < D; ++i) v[i] = static_cast<Scalar>(random.uniform(low, high));
  return v;
}

/// A box with its centre in [0, world) and half extents up to `half` on each axis.
template <int D>
Box<D> random_box(Random& random, double world, double half) {
  const Vector<D> center = random_point<D>(random, 0, world);
  const Vector<D> reach = random_point<D>(random, 0, half);
  return {center - reach, center + reach};
}

}  // namespace kerf::test
