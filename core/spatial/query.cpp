#include "core/spatial/query.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/float_mode.h"
#include "core/geometry/denormal.h"
#include "core/spatial/exact_sum.h"

namespace kerf {
namespace {

QueryStatus first_bad(std::initializer_list<QueryStatus> statuses) {
  const auto* const bad = std::ranges::find_if(statuses, [](QueryStatus s) { return s != QueryStatus::ok; });
  return bad == statuses.end() ? QueryStatus::ok : *bad;
}

/// Whether all are finite, for the usual numbers: false may be wrong.
template <class Number>
bool are_surely_finite(std::span<const Number> numbers) {
  Number sum = 0;
  for (const Number x : numbers) sum += x;
  return sum - sum == 0;
}

template <class Number>
QueryStatus check_finite(std::span<const Number> numbers) {
  if (are_surely_finite(numbers)) return QueryStatus::ok;
  if (std::ranges::any_of(numbers, [](Number x) { return std::isnan(x); })) return QueryStatus::not_a_number;
  const bool finite = std::ranges::all_of(numbers, [](Number x) { return std::isfinite(x); });
  return finite ? QueryStatus::ok : QueryStatus::not_finite;
}

template <int D>
QueryStatus check_finite(const Vector<D>& v) {
  return check_finite<Scalar>(v.value);
}

/// A length that may be infinite.
QueryStatus check_length(Scalar length) {
  if (std::isnan(length)) return QueryStatus::not_a_number;
  return wide(length) < 0 ? QueryStatus::not_ordered : QueryStatus::ok;
}

template <int D>
std::array<double, D> in_doubles(const Vector<D>& v) {
  std::array<double, D> doubles{};
  std::ranges::transform(v.value, doubles.begin(), wide);
  return doubles;
}

}  // namespace

std::string_view to_string(QueryStatus status) {
  switch (status) {
    case QueryStatus::ok:
      return "ok";
    case QueryStatus::not_a_number:
      return "not-a-number";
    case QueryStatus::not_finite:
      return "not-finite";
    case QueryStatus::not_ordered:
      return "not-ordered";
  }
  return "";
}

template <int D>
Cast<D>::Cast(const Ray<D>& ray)
    : box{ray.origin, ray.origin}, direction(in_doubles(ray.direction)), max_t(ray.max_t) {}

template <int D>
Cast<D>::Cast(const Segment<D>& segment) : box{segment.from, segment.from}, max_t(1) {
  const NearestRounding rounding;
  for (int i = 0; i < D; ++i) {
    const Exact way = difference(wide(segment.to[i]), wide(segment.from[i]));
    direction[static_cast<std::size_t>(i)] = way.value;
    rest[static_cast<std::size_t>(i)] = way.rest;
  }
}

template <int D>
Cast<D>::Cast(const SweptBox<D>& swept)
    : box(swept.box), direction(in_doubles(swept.displacement)), max_t(swept.max_t) {}

template <int D>
QueryStatus check(const Box<D>& box) {
  for (int i = 0; i < D; ++i)
    if (std::isnan(box.min[i]) || std::isnan(box.max[i])) return QueryStatus::not_a_number;
  for (int i = 0; i < D; ++i)
    if (wide(box.min[i]) > wide(box.max[i])) return QueryStatus::not_ordered;
  return QueryStatus::ok;
}

template <int D>
QueryStatus check(const Sphere<D>& sphere) {
  return first_bad({check_finite(sphere.center), check_length(sphere.radius)});
}

template <int D>
QueryStatus check(const Frustum<D>& frustum) {
  for (const Plane<D>& plane : frustum.planes) {
    const QueryStatus status =
        first_bad({check_finite(plane.normal), check_finite<Scalar>(std::span(&plane.offset, 1))});
    if (status != QueryStatus::ok) return status;
  }
  return QueryStatus::ok;
}

template <int D>
QueryStatus check(const Cast<D>& cast) {
  return first_bad({check_finite(cast.box.min), check_finite(cast.box.max), check(cast.box),
                    check_finite<double>(cast.direction), check_length(cast.max_t)});
}

template <int D>
QueryStatus check(const Nearest<D>& nearest) {
  return first_bad({check_finite(nearest.point), check_length(nearest.max_distance)});
}

#define KERF_INSTANTIATE(D)                         \
  template struct Cast<D>;                          \
  template QueryStatus check<D>(const Box<D>&);     \
  template QueryStatus check<D>(const Sphere<D>&);  \
  template QueryStatus check<D>(const Frustum<D>&); \
  template QueryStatus check<D>(const Cast<D>&);    \
  template QueryStatus check<D>(const Nearest<D>&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
