// The order in which a leaf's floats are compared, for each of the machine's kinds of vectors: included once
// for each by the kernels (Highway's foreach_target), so there is no `#pragma once`.
#if defined(KERF_ORDER_FLOATS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KERF_ORDER_FLOATS_INL_H
#undef KERF_ORDER_FLOATS_INL_H
#else
#define KERF_ORDER_FLOATS_INL_H
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "core/base/sample_place.h"
#include "core/geometry/sort_key.h"
#include "core/kernels/compare_dense-inl.h"
#include "core/kernels/float_sweep.h"
#include "core/kernels/leaf_view.h"
#include "core/kernels/sweep_tuning.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

/// The axis along which fewest entries begin within another one, in a sample. Far from all others or near
/// them, each counts alike: boxes of very different sizes have no mean length that says so.
template <int D>
std::size_t axis_of_short_rows(const LeafView<D>& leaf) {
  constexpr std::size_t kHalf = PackedBox<D>::kHalf;
  constexpr std::size_t kMost = tuning::kAxisSample;
  const std::size_t count = std::min(leaf.size(), kMost);
  std::array<std::array<Scalar, kMost>, 2> ends;
  std::array<std::uint32_t, D> within{};
  for (std::size_t axis = 0; axis < D; ++axis) {
    for (std::uint32_t k = 0; k < count; ++k) {
      const PackedBox<D>& box = leaf.boxes[sample_place(k, leaf.size())];
      ends[0][k] = box.lane[axis];
      ends[1][k] = -box.lane[kHalf + axis];
    }
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t k = 0; k < count; ++k)
        sum += static_cast<std::uint32_t>((ends[0][k] >= ends[0][i]) & (ends[0][k] <= ends[1][i]));
    within[axis] = sum;
  }
  return static_cast<std::size_t>(std::ranges::min_element(within) - within.begin());
}

/// Orders the entries by their beginnings, and fills a plane with each of their ends: those along the axis
/// first, then those of the others.
template <int D>
void order_by_floats(const LeafView<D>& leaf, std::size_t axis, FloatSweep& sweep) {
  constexpr std::size_t kHalf = PackedBox<D>::kHalf;
  const std::size_t n = leaf.size();
  sweep.make_room(n, 2 * D);
  sweep.order.items.resize(n);
  for (std::size_t i = 0; i < n; ++i)
    sweep.order.items[i] = {sort_key(leaf.boxes[i].lane[axis]), static_cast<std::uint32_t>(i)};
  sweep.order.sort();
  const RadixSort::Item* const items = sweep.order.items.data();
  DepthMask all = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const std::uint32_t place = items[k].value;
    const PackedBox<D>& box = leaf.boxes[place];
    for (std::size_t a = 0; a < D; ++a) {
      const std::size_t from = axis + a < D ? axis + a : axis + a - D;
      sweep.plane(2 * a)[k] = box.lane[from];
      sweep.plane(2 * a + 1)[k] = -box.lane[kHalf + from];
    }
    sweep.objects[k] = leaf.objects[place].value;
    sweep.apart[k] = leaf.apart[place];
    sweep.folded[k] = fold(leaf.apart[place]);
    all |= leaf.apart[place];
  }
  sweep.folds_decide = std::popcount(fold(all)) == std::popcount(all);
}

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
