#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "core/base/ids.h"
#include "core/geometry/box.h"
#include "core/geometry/denormal.h"
#include "core/geometry/plane.h"
#include "core/geometry/vector.h"

namespace kerf {

// What can be asked of the objects' boxes. All boxes and shapes are closed: touching counts. Answers are
// those of real arithmetic on the given floats, without any epsilon (DESIGN.md, "Queries").

/// The answer of a query about itself. If it is not `ok`, nothing was found and no result was appended.
enum class [[nodiscard]] QueryStatus : std::uint8_t{
    ok,
    not_a_number,  ///< a number of the query is NaN
    not_finite,    ///< an infinite origin, direction, centre or plane
    not_ordered,   ///< a box with min > max, a negative radius or length
};

std::string_view to_string(QueryStatus status);

/// All points within `radius` of the centre: a disc in 2D. The radius may be infinite.
template <int D>
struct Sphere {
  Vector<D> center;
  Scalar radius = 0;
};

/// The points on the left of all planes, `dot(normal, point) <= offset`; normals need not have length one. A
/// box is in it unless it lies wholly on the right of one plane, which is the usual test for what a camera
/// sees: a box near an edge of the frustum can be in it without touching it. The planes must outlive the
/// query.
template <int D>
struct Frustum {
  std::span<const Plane<D>> planes;
};

/// From `origin` along `direction`, which need not have length one and may be zero: then it is a point.
template <int D>
struct Ray {
  Vector<D> origin;
  Vector<D> direction;
  Scalar max_t = std::numeric_limits<Scalar>::infinity();  ///< length, in multiples of the direction
};

/// Both ends belong to it.
template <int D>
struct Segment {
  Vector<D> from;
  Vector<D> to;
};

/// A box that moves without turning.
template <int D>
struct SweptBox {
  Box<D> box;
  Vector<D> displacement;
  Scalar max_t = 1;  ///< how far, in multiples of the displacement
};

/// What rays, segments and swept boxes have in common: a box, or a point, on its straight way. It is at
/// `box + t * direction` for t from 0 to `max_t`, and hits an object at the least t at which it touches its
/// box: at 0 if it begins there. A direction component of zero leaves the box where it is on that axis.
template <int D>
struct Cast {
  Box<D> box;
  std::array<double, D> direction{};
  std::array<double, D> rest{};  ///< what rounding took from `direction`: their sum is exact
  Scalar max_t = std::numeric_limits<Scalar>::infinity();

  Cast(const Ray<D>& ray);          // NOLINT(google-explicit-constructor): every ray is one
  Cast(const Segment<D>& segment);  // NOLINT(google-explicit-constructor): every segment is one
  Cast(const SweptBox<D>& swept);   // NOLINT(google-explicit-constructor): every swept box is one
};

/// An object that a cast hits, and where: `t` is the largest quotient of the axes, computed in doubles and
/// then rounded to a float.
struct alignas(8) Hit {
  ObjectId object;
  Scalar t = 0;
  friend constexpr bool operator==(const Hit&, const Hit&) = default;
};

/// The order of hits: by t, equal ones by id. Denormals count, also where the processor takes them for zero.
constexpr bool operator<(const Hit& a, const Hit& b) {
  const double t_of_a = wide(a.t);
  const double t_of_b = wide(b.t);
  return t_of_a != t_of_b ? t_of_a < t_of_b : a.object < b.object;
}

/// The `count` objects whose boxes are nearest to a point, no farther than `max_distance`. The distance to a
/// box that holds the point is 0.
template <int D>
struct Nearest {
  Vector<D> point;
  std::size_t count = 1;
  Scalar max_distance = std::numeric_limits<Scalar>::infinity();
};

/// An object and the square of its box's distance, which is summed in doubles in the order of the axes.
struct Neighbour {
  ObjectId object;
  double squared_distance = 0;
  friend constexpr bool operator==(const Neighbour&, const Neighbour&) = default;
};

/// The order of neighbours: by distance, equal ones by id.
constexpr bool operator<(const Neighbour& a, const Neighbour& b) {
  return a.squared_distance != b.squared_distance ? a.squared_distance < b.squared_distance
                                                  : a.object < b.object;
}

/// Which objects take part in a query. All do, if nothing is set.
struct Filter {
  /// An object takes part if its categories and the mask have a common bit.
  std::uint32_t mask = UINT32_MAX;
  /// By object id; the objects beyond its end have all categories. Must outlive the query.
  std::span<const std::uint32_t> categories;
  /// Asked last, for objects that the query would report; null accepts all. It may be called for an object
  /// that is not reported in the end, since others are nearer. It must not throw. Like a visitor it may be
  /// called while results are rounded to nearest, or denormals are kept, whatever the caller has chosen.
  bool (*accepts)(void* context, ObjectId object) = nullptr;
  void* context = nullptr;

  [[nodiscard]] bool takes(ObjectId object) const {
    if (object.index() < categories.size() && (categories[object.index()] & mask) == 0) return false;
    return accepts == nullptr || accepts(context, object);
  }
  [[nodiscard]] bool takes_all() const { return categories.empty() && accepts == nullptr; }
};

// Whether a query can be answered at all.
template <int D>
QueryStatus check(const Box<D>& box);
template <int D>
QueryStatus check(const Sphere<D>& sphere);
template <int D>
QueryStatus check(const Frustum<D>& frustum);
template <int D>
QueryStatus check(const Cast<D>& cast);
template <int D>
QueryStatus check(const Nearest<D>& nearest);

}  // namespace kerf
