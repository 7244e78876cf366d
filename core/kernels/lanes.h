#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/ids.h"
#include "core/base/pair_list.h"
#include "core/geometry/box.h"

namespace kerf {

/// Boxes as arrays, one per bound, so that a vector instruction tests many of them. Axis 0 is the first that
/// a kernel tests, not necessarily the world's. Beyond the last box are `kPadding` ones that overlap nothing.
template <int D>
struct Lanes {
  static constexpr std::size_t kPadding = 64;

  std::array<std::vector<Scalar>, D> min;
  std::array<std::vector<Scalar>, D> max;
  std::vector<std::uint32_t> object;
  /// Exclusion masks: two boxes are a pair only if theirs have no common bit. Fixed objects share one, for
  /// example.
  std::vector<std::uint32_t> apart;
  std::size_t size = 0;

  void resize(std::size_t count);
  void set(std::size_t place, const Box<D>& box, ObjectId id, std::uint32_t apart_bits);
};

/// Appends the pairs of boxes that are sorted by `min[0]`.
template <int D>
void sweep_lanes(const Lanes<D>& lanes, PairList& pairs);

/// Appends the pairs of boxes in any order, by testing those from `first` up to `last` against all that
/// follow them.
template <int D>
void test_lanes(const Lanes<D>& lanes, std::size_t first, std::size_t last, PairList& pairs);

}  // namespace kerf
