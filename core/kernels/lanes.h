#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/base/ids.h"
#include "core/base/pair_list.h"
#include "core/geometry/box.h"

namespace kerf {

/// Boxes as arrays, one per bound, so that a vector instruction tests many of them. Axis 0 is the first that
/// a kernel looks at, which need not be the world's. Beyond the last box are `kPadding` ones that overlap
/// nothing.
template <int D>
struct Lanes {
  static constexpr std::size_t kPadding = 64;

  std::array<std::vector<Scalar>, D> min;
  std::array<std::vector<Scalar>, D> max;
  std::vector<std::uint32_t> object;
  /// Two boxes are a pair only if they have no bit in common, for example that of fixed objects.
  std::vector<std::uint32_t> apart;
  std::size_t size = 0;

  void resize(std::size_t count);
  void set(std::size_t place, const Box<D>& box, ObjectId id, std::uint32_t apart_bits);
};

/// Appends the pairs of boxes that are sorted by `min[0]`.
template <int D>
void sweep_lanes(const Lanes<D>& lanes, PairList& pairs);

/// Appends the pairs of boxes in any order, by testing each with each.
template <int D>
void test_lanes(const Lanes<D>& lanes, PairList& pairs);

extern template struct Lanes<2>;
extern template struct Lanes<3>;

}  // namespace kerf
