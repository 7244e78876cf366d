#include "core/spatial/block_query.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/geometry/denormal.h"

namespace kerf {
namespace {

// The kernels' sums and products of three floats have errors far below this share of their terms.
constexpr double kSlack = 0x1p-20;
constexpr double kTiny = 0x1p-140;
/// Below this, squared distances may be zero for a processor that takes denormals for zero.
constexpr double kLeastSure = 0x1p-100;

/// More than a difference of floats loses where denormals, in operands and results, are taken for zero; only
/// floats near zero have such differences.
constexpr Scalar kLost = 0x1p-123F;
constexpr Scalar kNearZero = 0x1p-100F;

/// A coordinate from which every box has a finite distance.
bool is_usual(Scalar coordinate) { return std::abs(coordinate) <= 0x1p102F; }

template <int D>
bool are_usual(const Vector<D>& point) {
  return std::ranges::all_of(point.value, is_usual);
}

bool has_usual_size(double factor) {
  return factor == 0 || (std::abs(factor) >= 0x1p-100 && std::abs(factor) <= 0x1p100);
}

/// `n` times a power of two, so that the largest component is from 1/8 to 1/4.
template <int D>
RoundedHalfSpace<D> make_space(const Plane<D>& plane, bool& works) {
  double largest = 0;
  for (const Scalar x : plane.normal.value) largest = std::max(largest, std::abs(wide(x)));
  int exponent = 0;
  (void)std::frexp(largest, &exponent);
  const int scale = -exponent - 2;
  RoundedHalfSpace<D> space;
  for (std::size_t i = 0; i < D; ++i) {
    const double component = std::ldexp(wide(plane.normal.value[i]), scale);
    works &= has_usual_size(component);
    space.normal[i] = static_cast<Scalar>(component);
  }
  const double offset = std::ldexp(wide(plane.offset), scale);
  space.possible = round_up(offset);
  space.sure = round_down(offset);
  return space;
}

}  // namespace

Scalar bound_above(double squared_distance) {
  const double bound = squared_distance * (1 + kSlack) + kTiny;
  constexpr double kMax = std::numeric_limits<Scalar>::max();
  return bound > kMax ? std::numeric_limits<Scalar>::infinity() : static_cast<Scalar>(bound);
}

template <int D>
SphereQuery<D>::SphereQuery(const Sphere<D>& sphere)
    : works(are_usual(sphere.center) && sphere.radius <= 0x1p62F) {
  const double reach = static_cast<double>(sphere.radius) * static_cast<double>(sphere.radius);
  test.center = sphere.center.value;
  test.possible = bound_above(reach);
  const double sure = reach * (1 - kSlack) - kTiny;
  test.sure = sure < kLeastSure ? -1 : round_down(sure);
}

template <int D>
CastQuery<D>::CastQuery(const Cast<D>& cast) : works(are_usual(cast.box.min) && are_usual(cast.box.max)) {
  test.near_start = cast.box.max.value;
  test.far_start = cast.box.min.value;
  test.max_t = cast.max_t;
  test.blur = 0x1p-100F;
  for (std::size_t i = 0; i < D; ++i) {
    const double direction = cast.direction[i];
    works &= has_usual_size(direction);
    test.moves_on_all &= direction != 0;
    if (direction == 0) continue;
    test.direction[i] = direction;
    const double inverse = 1 / direction;
    test.near_factor[i] = static_cast<Scalar>((1 - kSlack) * inverse);
    test.far_factor[i] = static_cast<Scalar>((1 + kSlack) * inverse);
    if (direction < 0) std::swap(test.near_start[i], test.far_start[i]);
    test.start[i] = test.near_start[i];
    if (std::min(std::abs(test.near_start[i]), std::abs(test.far_start[i])) >= kNearZero) continue;
    const Scalar lost = direction < 0 ? -kLost : kLost;
    test.near_start[i] += lost;
    test.far_start[i] -= lost;
    test.blur = std::max(test.blur, 8 * kLost * std::abs(test.far_factor[i]));
  }
}

template <int D>
FrustumQuery<D>::FrustumQuery(const Frustum<D>& frustum) {
  const std::size_t count = std::min(frustum.planes.size(), kMost);
  for (std::size_t k = 0; k < count; ++k) spaces[k] = make_space(frustum.planes[k], works);
  if (count < frustum.planes.size())  // no box is surely left of the last one: each is looked at
    spaces.back().sure = -std::numeric_limits<Scalar>::infinity();
  test.all = std::span(spaces.data(), count);
}

#define KERF_INSTANTIATE(D)       \
  template struct SphereQuery<D>; \
  template struct CastQuery<D>;   \
  template struct FrustumQuery<D>;
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
