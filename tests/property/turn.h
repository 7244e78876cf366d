#pragma once

#include <array>
#include <cmath>

#include "core/base/random.h"
#include "core/geometry/precise.h"

namespace kerf::test {

/// A direction of length one: often a signed axis, else anything.
template <int D>
Precise<D> random_unit(Random& random) {
  Precise<D> p{};
  if (random.below(3) == 0) {
    const std::uint32_t axis = random.below(D);
    p[axis] = random.below(2) == 0 ? 1 : -1;
    return p;
  }
  double norm2 = 0;
  while (norm2 < 1e-2) {
    for (double& x : p) x = random.uniform(-1, 1);
    norm2 = inner<D>(p, p);
  }
  for (double& x : p) x /= std::sqrt(norm2);
  return p;
}

/// Orthonormal axes turned by an angle in a random coordinate plane.
template <int D>
std::array<Vector<D>, D> turned(const std::array<Vector<D>, D>& axes, double angle, Random& random) {
  const std::uint32_t first = random.below(D);
  const std::uint32_t second = (first + 1 + random.below(D - 1)) % D;
  std::array<Vector<D>, D> result = axes;
  for (std::size_t k = 0; k < D; ++k) {
    const auto a = static_cast<double>(axes[k].value[first]);
    const auto b = static_cast<double>(axes[k].value[second]);
    result[k].value[first] = static_cast<Scalar>(std::cos(angle) * a - std::sin(angle) * b);
    result[k].value[second] = static_cast<Scalar>(std::sin(angle) * a + std::cos(angle) * b);
  }
  return result;
}

/// One of the axes that can separate two oriented boxes, of length one, or any other direction.
template <int D>
Precise<D> separating_axis(const std::array<Vector<D>, D>& a, const std::array<Vector<D>, D>& b,
                           Random& random) {
  const Precise<D> u = to_precise(a[random.below(D)]);
  const Precise<D> v = to_precise(b[random.below(D)]);
  const std::uint32_t sort = random.below(4);
  Precise<D> axis = sort == 0 ? u : sort == 1 ? v : random_unit<D>(random);
  if constexpr (D == 3) {
    if (sort == 2) axis = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  }
  const double norm = std::sqrt(inner<D>(axis, axis));
  if (norm == 0) return u;
  for (double& x : axis) x /= norm;
  return axis;
}

}  // namespace kerf::test
