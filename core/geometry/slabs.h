#pragma once

#include <array>
#include <span>

#include "core/geometry/volume.h"

namespace kerf {

/// The directions of a DOP's slabs, the axes first; components are integers. Just the axes for other kinds.
template <int D>
std::span<const Vector<D>> slab_directions(VolumeKind kind);

/// A direction as a sum of slabs with non-negative weights. `slab[k]` is an index in `slab_directions`;
/// `flip[k]` says that the slab is taken against its direction, so that its high end bounds the low end of
/// the sum.
template <int D>
struct SlabSum {
  std::array<std::uint32_t, D> slab{};
  std::array<bool, D> flip{};
  std::array<Scalar, D> weight{};
};

/// The tightest sum for a direction: the slabs of a cone that contains it. For a slab's own direction it is
/// that slab alone.
///
/// Projecting by such a sum, lo = w0*lo0 + w1*lo1 + w2*lo2 in one fixed order, is monotone in each slab end,
/// as the box's own corners are (DESIGN.md, "Classification"): volumes whose slabs overlap have sums that
/// overlap, whatever the rounding of the weights.
template <int D>
SlabSum<D> sum_of_slabs(VolumeKind kind, const Vector<D>& direction);

}  // namespace kerf
