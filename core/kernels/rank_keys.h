#pragma once

#include <array>
#include <span>

#include "core/kernels/leaf_view.h"

namespace kerf {

/// A monotone map to bytes for boxes in clumps that lie far from one another, where a `ByteScale` has one
/// byte for a whole clump: an end becomes the number of these beginnings that are at most as large. So there
/// are as many bytes as boxes wherever boxes lie.
template <int D>
struct RankScale {
  static constexpr std::size_t kRanks = 255;
  std::array<std::array<Scalar, kRanks>, D> beginnings;  ///< of each axis, ascending
};

/// By the beginnings of some of the boxes.
template <int D>
RankScale<D> make_rank_scale(std::span<const PackedBox<D>> boxes);

template <int D>
ByteKey<D> rank_key(const PackedBox<D>& box, const RankScale<D>& scale);

/// The scale for boxes that moved by a vector.
template <int D>
void move_scale(RankScale<D>& scale, const Vector<D>& by);

}  // namespace kerf
