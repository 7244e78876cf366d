#include "core/spatial/touch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/geometry/denormal.h"
#include "core/spatial/exact_sum.h"

namespace kerf {
namespace {

// Doubles decide unless their rounding could: no error exceeds this share of the numbers added. The rest is
// left to exact sums.
constexpr double kRounding = 0x1p-48;

/// On one axis, t is at least begin / speed and at most end / speed; the speed is positive.
struct Slab {
  Exact begin;
  Exact end;
  Exact speed;
};

Exact minus(const Exact& x) { return {-x.value, -x.rest}; }

/// The axes on which the cast moves.
template <int D>
struct Slabs {
  std::array<Slab, D> slab;
  std::size_t count = 0;
};

/// False if an axis on which the cast does not move keeps it apart from the box.
template <int D>
bool make_slabs(const Cast<D>& cast, const Box<D>& box, Slabs<D>& slabs) {
  for (int i = 0; i < D; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Exact speed{cast.direction[k], cast.rest[k]};
    if (speed.value == 0) {
      if (wide(cast.box.max[i]) < wide(box.min[i]) || wide(box.max[i]) < wide(cast.box.min[i])) return false;
      continue;
    }
    const Exact up = difference(wide(box.min[i]), wide(cast.box.max[i]));
    const Exact down = difference(wide(box.max[i]), wide(cast.box.min[i]));
    slabs.slab[slabs.count++] =
        speed.value > 0 ? Slab{up, down, speed} : Slab{minus(down), minus(up), minus(speed)};
  }
  return true;
}

/// a * b <= c * d.
bool product_at_most(const Exact& a, const Exact& b, const Exact& c, const Exact& d) {
  const double left = a.value * b.value;
  const double right = c.value * d.value;
  if (std::abs(left - right) > kRounding * (std::abs(left) + std::abs(right))) return left < right;
  ExactSum sum;
  sum.add_product(a, b);
  sum.add_product(minus(c), d);
  return sum.sign() <= 0;
}

/// How far the point lies beyond the box on an axis.
template <int D>
Exact beyond(const Vector<D>& point, const Box<D>& box, int axis) {
  const double place = wide(point[axis]);
  const double min = wide(box.min[axis]);
  const double max = wide(box.max[axis]);
  if (place < min) return difference(min, place);
  if (place > max) return difference(place, max);
  return {};
}

/// Whether some corner lies on the left of the plane.
template <int D>
bool reaches_left(const Plane<D>& plane, const Box<D>& box) {
  std::array<double, D + 1> terms{};
  double sum = 0;
  double size = 0;
  for (int i = 0; i < D; ++i)  // products of two floats are exact
    terms[static_cast<std::size_t>(i)] =
        wide(plane.normal[i]) * wide(std::signbit(plane.normal[i]) ? box.max[i] : box.min[i]);
  terms[D] = -wide(plane.offset);
  for (const double term : terms) {
    sum += term;
    size += std::abs(term);
  }
  if (std::abs(sum) > kRounding * size) return sum < 0;
  ExactSum exact;
  for (const double term : terms) exact.add(term);
  return exact.sign() <= 0;
}

template <int D, class ToDouble>
double sum_of_squares(const Vector<D>& point, const Box<D>& box, ToDouble to_double) {
  double sum = 0;
  for (int i = 0; i < D; ++i) {
    const double place = to_double(point[i]);
    const double apart = std::max({to_double(box.min[i]) - place, place - to_double(box.max[i]), 0.0});
    sum += apart * apart;
  }
  return sum;
}

template <int D>
[[gnu::noinline]] double wide_squared_distance(const Vector<D>& point, const Box<D>& box) {
  return sum_of_squares(point, box, wide);
}

}  // namespace

template <int D>
bool touches(const Sphere<D>& sphere, const Box<D>& box) {
  if (std::isinf(sphere.radius)) return true;
  std::array<Exact, D> apart;
  double distance = 0;
  for (int i = 0; i < D; ++i) {
    const auto k = static_cast<std::size_t>(i);
    apart[k] = beyond(sphere.center, box, i);
    distance += apart[k].value * apart[k].value;
  }
  const double reach = wide(sphere.radius) * wide(sphere.radius);
  if (std::abs(distance - reach) > kRounding * (distance + reach)) return distance < reach;
  ExactSum sum;
  for (const Exact& along : apart) sum.add_product(along, along);
  sum.add_product(-wide(sphere.radius), wide(sphere.radius));
  return sum.sign() <= 0;
}

template <int D>
bool touches(const Frustum<D>& frustum, const Box<D>& box) {
  return std::ranges::all_of(frustum.planes, [&](const Plane<D>& p) { return reaches_left(p, box); });
}

template <int D>
bool touches(const Cast<D>& cast, const Box<D>& box) {
  Slabs<D> slabs;
  if (!make_slabs(cast, box, slabs)) return false;
  const std::span<const Slab> all(slabs.slab.data(), slabs.count);
  for (const Slab& slab : all) {
    if (slab.end.value < 0) return false;
    const bool short_of =
        std::isfinite(cast.max_t) && !product_at_most(slab.begin, {1, 0}, {wide(cast.max_t), 0}, slab.speed);
    if (short_of) return false;
    for (const Slab& other : all)
      if (&slab != &other && !product_at_most(slab.begin, other.speed, other.end, slab.speed)) return false;
  }
  return true;
}

template <int D>
Scalar entry_of(const Cast<D>& cast, const Box<D>& box) {
  double t = 0;
  for (int i = 0; i < D; ++i) {
    const double direction = cast.direction[static_cast<std::size_t>(i)];
    if (direction == 0) continue;
    const double ahead = direction > 0
                             ? static_cast<double>(box.min[i]) - static_cast<double>(cast.box.max[i])
                             : static_cast<double>(box.max[i]) - static_cast<double>(cast.box.min[i]);
    t = std::max(t, ahead / direction);
  }
  return static_cast<Scalar>(std::min(t, static_cast<double>(std::numeric_limits<Scalar>::max())));
}

template <int D>
double squared_distance(const Vector<D>& point, const Box<D>& box) {
  const double usual = sum_of_squares(point, box, [](Scalar x) { return static_cast<double>(x); });
  if (usual >= 0x1p-80) [[likely]]  // what denormals add is less than its last place
    return usual;
  return wide_squared_distance(point, box);
}

#define KERF_INSTANTIATE(D)                                   \
  template bool touches<D>(const Sphere<D>&, const Box<D>&);  \
  template bool touches<D>(const Frustum<D>&, const Box<D>&); \
  template bool touches<D>(const Cast<D>&, const Box<D>&);    \
  template Scalar entry_of<D>(const Cast<D>&, const Box<D>&); \
  template double squared_distance<D>(const Vector<D>&, const Box<D>&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
