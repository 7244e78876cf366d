#include "core/kernels/byte_sweep.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/base/tuning.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/byte_sweep.cpp"
#include <hwy/foreach_target.h>

#include "core/kernels/compare-inl.h"
#include "core/kernels/compare_dense-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

/// Whether so much would be found that it pays to separate what bytes alone prove, if boxes of such a mean
/// length along each axis, in bytes, lay anywhere: more than a few in a row of 64.
template <std::size_t D>
HWY_INLINE bool would_be_dense(std::size_t count, const std::array<float, D>& length, std::size_t axis) {
  const auto n = static_cast<float>(count);
  float sure = n * (length[axis] - 1) / 255;
  for (std::size_t other = 0; other < D; ++other)
    if (other != axis) sure *= std::clamp(2 * (length[other] - 1) / 255, 0.0F, 1.0F);
  const float rows = n * length[axis] / 255 / 64 + 0.5F;
  return sure > tuning::kSurePerRow * rows;
}

/// Fills `keys`, chooses the axis along which the boxes are shortest, and sets whether rows must be counted
/// to know how dense they lie: in a small leaf only if its mean lengths say so.
template <int D>
HWY_INLINE void make_keys(const LeafView<D>& leaf, ByteSweep<D>& sweep) {
  const ByteMap<D> map(make_byte_scale(leaf));
  ByteKey<D>* const HWY_RESTRICT keys = sweep.keys.data();
  Packed<D> sums[kChains];
  for (Packed<D>& chain : sums) chain = all_lanes<D>(0);
  const auto add = [](const Packed<D>& from, Packed<D>& to) HWY_ATTR {
    for (std::size_t k = 0; k < Packed<D>::kParts; ++k) to.part[k] = hn::Add(to.part[k], from.part[k]);
  };
  in_chains(leaf.size(), [&](std::size_t i, std::size_t chain) HWY_ATTR {
    const Packed<D> ends = map(leaf.boxes[i]);
    add(ends, sums[chain]);
    keys[i] = byte_key<D>(ends);
  });
  for (std::size_t chain = 1; chain < kChains; ++chain) add(sums[chain], sums[0]);
  PackedBox<D> sum;
  store(sums[0], sum);
  std::array<float, D> length;  // in the mean
  for (std::size_t axis = 0; axis < D; ++axis)
    length[axis] = (sum.lane[PackedBox<D>::kHalf + axis] - sum.lane[axis]) / static_cast<float>(leaf.size());
  const auto axis = static_cast<std::size_t>(std::ranges::min_element(length) - length.begin());
  sweep.axis = static_cast<int>(axis);
  sweep.is_dense =
      sweep.may_be_dense && (leaf.size() >= tuning::kLeastCrowd || would_be_dense(leaf.size(), length, axis));
}

/// Counts the entries that begin at each byte of the axis, and writes their places and bytes in that order.
/// The order is stable. The entries stay where they are: copying them costs more than finding them by their
/// places.
template <int D>
HWY_INLINE void order_entries(const LeafView<D>& leaf, ByteSweep<D>& sweep) {
  const std::size_t n = leaf.size();
  const unsigned shift = 8U * static_cast<unsigned>(sweep.axis);
  const ByteKey<D>* const keys = sweep.keys.data();
  std::uint32_t* const ends = sweep.ends.data();
  std::fill_n(ends, 257, 0U);
  for (std::size_t i = 0; i < n; ++i) ++ends[((keys[i] >> shift) & 255U) + 1];
  for (std::size_t q = 1; q < 257; ++q) ends[q] += ends[q - 1];
  std::uint32_t next[256];
  std::copy_n(ends, 256, next);
  std::uint32_t* const HWY_RESTRICT order = sweep.order.data();
  ByteKey<D>* const HWY_RESTRICT sorted_keys = sweep.sorted_keys.data();
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t place = next[(keys[i] >> shift) & 255U]++;
    order[place] = static_cast<std::uint32_t>(i);
    sorted_keys[place] = keys[i];
  }
  for (unsigned k = 0; k < 2U * D; ++k) {
    const unsigned byte = 8U * (k < D ? k : k - D + PackedBox<D>::kHalf);
    std::uint8_t* const HWY_RESTRICT plane = sweep.plane(k);
    for (std::size_t i = 0; i < n; ++i) plane[i] = static_cast<std::uint8_t>(sorted_keys[i] >> byte);
  }
}

template <int D>
HWY_INLINE void find_pairs(const LeafView<D>& leaf, ByteSweep<D>& sweep, PairBuffer& pairs) {
  sweep.make_room(leaf.size());
  make_keys(leaf, sweep);
  order_entries(leaf, sweep);
  const auto n = static_cast<std::uint32_t>(leaf.size());
  sweep.is_dense = sweep.is_dense && n > 1 && sure_in_row(sweep, n) > tuning::kSurePerRow;
  sweep.is_dense ? compare_dense(leaf, sweep, pairs) : compare_all(leaf, sweep, pairs);
}

void find_2(const LeafView<2>& leaf, ByteSweep<2>& sweep, PairBuffer& pairs) {
  find_pairs(leaf, sweep, pairs);
}
void find_3(const LeafView<3>& leaf, ByteSweep<3>& sweep, PairBuffer& pairs) {
  find_pairs(leaf, sweep, pairs);
}

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kerf {

HWY_EXPORT(find_2);
HWY_EXPORT(find_3);

template <int D>
void ByteSweep<D>::make_room(std::size_t n) {
  stride = n + kPad;
  if (planes.size() < stride * 2 * D) planes.resize(stride * 2 * D);
  keys.resize(n);
  sorted_keys.resize(n);
  order.resize(n);
}

template <int D>
void ByteSweep<D>::find(const LeafView<D>& leaf, PairBuffer& pairs) {
  if constexpr (D == 2) {
    HWY_DYNAMIC_DISPATCH(find_2)(leaf, *this, pairs);
  } else {
    HWY_DYNAMIC_DISPATCH(find_3)(leaf, *this, pairs);
  }
}

template class ByteSweep<2>;
template class ByteSweep<3>;

}  // namespace kerf
#endif
