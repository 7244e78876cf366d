#pragma once

#include <array>
#include <cstddef>

#include "core/kernels/search_blocks.h"
#include "core/spatial/query.h"

namespace kerf {

// What the kernels need to know of a query. Where a number of the query is so large or small that floats
// could overflow, there is no test (`works` is false), and every box must be looked at.

template <int D>
struct SphereQuery {
  explicit SphereQuery(const Sphere<D>& sphere);
  BallTest<D> test;
  bool works = true;
};

template <int D>
struct CastQuery {
  explicit CastQuery(const Cast<D>& cast);
  CastTest<D> test;
  bool works = true;
};

/// Of more planes than it has room for it tests the first ones, and is never sure.
template <int D>
struct FrustumQuery {
  explicit FrustumQuery(const Frustum<D>& frustum);
  FrustumQuery(const FrustumQuery&) = delete;
  FrustumQuery& operator=(const FrustumQuery&) = delete;
  static constexpr std::size_t kMost = 16;
  std::array<RoundedHalfSpace<D>, kMost> spaces;
  HalfSpacesTest<D> test;
  bool works = true;
};

/// The bound for squared distances in floats within which everything lies that is no farther than this; its
/// slack is larger than all roundings, that to a float, too.
Scalar bound_above(double squared_distance);

}  // namespace kerf
