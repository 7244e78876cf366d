#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace kerf {

/// The one scalar of boxes, planes and projections. Exactness (DESIGN.md) is argued for this type.
using Scalar = float;

/// A point or direction of D floats. It is an aggregate, so that arrays of it are plain memory.
template <int D>
struct Vector {
  static_assert(D == 2 || D == 3);
  std::array<Scalar, D> value{};

  constexpr Scalar& operator[](int axis) { return value[static_cast<std::size_t>(axis)]; }
  constexpr Scalar operator[](int axis) const { return value[static_cast<std::size_t>(axis)]; }
  friend constexpr bool operator==(const Vector&, const Vector&) = default;
};

template <int D>
constexpr Vector<D> operator+(Vector<D> a, const Vector<D>& b) {
  for (int i = 0; i < D; ++i) a[i] += b[i];
  return a;
}

template <int D>
constexpr Vector<D> operator-(Vector<D> a, const Vector<D>& b) {
  for (int i = 0; i < D; ++i) a[i] -= b[i];
  return a;
}

template <int D>
constexpr Vector<D> operator*(Vector<D> a, Scalar s) {
  for (int i = 0; i < D; ++i) a[i] *= s;
  return a;
}

/// Dot product in the one fixed order of operations: ((a0*b0 + a1*b1) + a2*b2). Each rounded step is
/// monotone in each argument, which is what makes classification exact (DESIGN.md, "Correct pairs").
template <int D>
constexpr Scalar dot(const Vector<D>& a, const Vector<D>& b) {
  Scalar sum = a[0] * b[0];
  for (int i = 1; i < D; ++i) sum = sum + a[i] * b[i];
  return sum;
}

template <int D>
Scalar length(const Vector<D>& a) {
  return std::sqrt(dot(a, a));
}

/// The unit vector along axis `axis`.
template <int D>
constexpr Vector<D> axis_vector(int axis) {
  Vector<D> v;
  v[axis] = 1;
  return v;
}

template <int D>
constexpr std::array<Vector<D>, D> identity_axes() {
  std::array<Vector<D>, D> axes;
  for (int i = 0; i < D; ++i) axes[static_cast<std::size_t>(i)] = axis_vector<D>(i);
  return axes;
}

template <int D>
bool is_finite(const Vector<D>& a) {
  for (int i = 0; i < D; ++i)
    if (!std::isfinite(a[i])) return false;
  return true;
}

}  // namespace kerf
