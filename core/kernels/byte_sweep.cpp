#include "core/kernels/byte_sweep.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/base/list_room.h"
#include "core/base/sample_place.h"
#include "core/kernels/sweep_tuning.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/byte_sweep.cpp"
#include <hwy/foreach_target.h>

#include "core/kernels/compare-inl.h"
#include "core/kernels/compare_dense-inl.h"
#include "core/kernels/compare_floats-inl.h"
#include "core/kernels/order-inl.h"

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

/// Whether many entries that begin at the byte at which another one ends would be found: on the other axes
/// nothing keeps them apart.
template <std::size_t D>
HWY_INLINE bool are_bytes_coarse(std::size_t count, const std::array<float, D>& length, std::size_t axis) {
  float found = static_cast<float>(count) / 255;
  for (std::size_t other = 0; other < D; ++other)
    if (other != axis) found *= std::clamp(2 * (length[other] + 1) / 255, 0.0F, 1.0F);
  return found > tuning::kTooCoarse;
}

/// Fills `keys`. Returns the mean length of the boxes along each axis, in bytes.
template <int D>
HWY_INLINE std::array<float, D> make_keys(const LeafView<D>& leaf, const ByteScale<D>& scale,
                                          ByteSweep<D>& sweep) {
  const ByteMap<D> map(scale);
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
  std::array<float, D> length;
  for (std::size_t axis = 0; axis < D; ++axis)
    length[axis] = (sum.lane[PackedBox<D>::kHalf + axis] - sum.lane[axis]) / static_cast<float>(leaf.size());
  return length;
}

/// Chooses the axis along which the boxes are shortest, and sets how the entries are ordered and compared.
template <std::size_t D>
HWY_INLINE void choose_axis(std::size_t count, const std::array<float, D>& length,
                            ByteSweep<static_cast<int>(D)>& sweep) {
  const auto axis = static_cast<std::size_t>(std::ranges::min_element(length) - length.begin());
  sweep.axis = static_cast<int>(axis);
  sweep.is_fine = are_bytes_coarse(count, length, axis);
  sweep.is_short = static_cast<float>(count) * (length[axis] + 1) / 255 < tuning::kShortRow;
}

/// Whether it may be that the boxes of a leaf lie dense: in a small one only their mean lengths say so.
template <std::size_t D>
HWY_INLINE bool may_be_dense(std::size_t count, const std::array<float, D>& length, std::size_t axis) {
  return count >= tuning::kLeastCrowd || (count > 1 && would_be_dense(count, length, axis));
}

/// Whether it may be that they lie in clumps.
template <std::size_t D>
HWY_INLINE bool may_be_clumped(std::size_t count, const std::array<float, D>& length) {
  return count >= tuning::kLeastCrowd ||
         (count >= tuning::kLeastSampled && std::ranges::max(length) < tuning::kTinyBox);
}

/// Entries that begin at the same bytes as an entry, in the mean, as a sample shows it.
template <int D>
HWY_INLINE float mean_clump(const ByteSweep<D>& sweep, std::size_t n) {
  constexpr std::uint32_t kCount = tuning::kClumpSample;
  constexpr auto kBegin = static_cast<ByteKey<D>>((std::uint64_t{1} << (8 * D)) - 1);
  ByteKey<D> begins[kCount];
  for (std::uint32_t k = 0; k < kCount; ++k) begins[k] = sweep.keys[sample_place(k, n)] & kBegin;
  std::uint32_t equal = 0;
  for (const ByteKey<D> begin : begins)
    for (const ByteKey<D> other : begins) equal += begin == other ? 1 : 0;
  return static_cast<float>(n) * static_cast<float>(equal - kCount) / (kCount * (kCount - 1));
}

/// Whether boxes lie in clumps that are too small to be swept one by one, so that no bytes need an order.
template <int D>
HWY_INLINE bool lie_in_small_clumps(const std::array<float, D>& length, const ByteSweep<D>& sweep,
                                    std::size_t n) {
  if (n < tuning::kLeastSampled || std::ranges::max(length) >= tuning::kTinyBox) return false;
  const float size = mean_clump<D>(sweep, n);
  return size > tuning::kClumped && size < static_cast<float>(tuning::kLeastMeanClump);
}

template <int D>
HWY_INLINE void sweep_floats(const LeafView<D>& leaf, ByteSweep<D>& sweep, PairBuffer& pairs) {
  sweep.is_clumped = true;
  sweep.axis = static_cast<int>(axis_of_short_rows(leaf));
  compare_floats(leaf, static_cast<std::size_t>(sweep.axis), sweep.floats, sweep.found, pairs);
}

/// How the entries of a leaf are compared.
enum class Comparison : std::uint8_t { bytes, dense_bytes, floats };

/// Decides by rows how a leaf is compared: `rows` are some in the order so far. The boxes of a slanted line
/// do not all meet on any axis, so only the rows show that they need finer steps: then the entries are
/// ordered anew. Straight lines, known by mean lengths, are ordered once, which saves 5 to 10 % of their
/// time. Where finer steps do not help, or it takes too many, floats are swept.
template <int D>
HWY_INLINE Comparison comparison_by_rows(const LeafView<D>& leaf, const ByteScale<D>& scale, RowSample rows,
                                         ByteSweep<D>& sweep) {
  if (rows.all_at_end > tuning::kClumped) return Comparison::floats;
  const auto n = static_cast<std::uint32_t>(leaf.size());
  if (!sweep.is_fine && rows.at_end > tuning::kTooCoarse) {
    sweep.is_fine = true;
    order_entries(leaf, scale, sweep);
    rows = sample_rows(sweep, n);
    if (rows.all_at_end > tuning::kClumped) return Comparison::floats;
  }
  const float least = sweep.is_short ? tuning::kSurePerShortRow : tuning::kSurePerRow;
  return rows.sure > least && sweep.may_be_dense ? Comparison::dense_bytes : Comparison::bytes;
}

/// Divides a leaf of clumps. A finer step may reach from one byte into the next.
template <int D>
bool divide_clumps(const LeafView<D>& leaf, ByteSweep<D>& sweep) {
  const auto axis = static_cast<std::size_t>(sweep.axis);
  const OrderedBytes bytes{
      {sweep.order.data(), leaf.size()}, sweep.plane(axis), sweep.plane(D + axis), sweep.is_fine ? 1 : 0};
  return sweep.clumps.divide(leaf, bytes);
}

template <int D>
HWY_INLINE void compare_bytes(const LeafView<D>& leaf, ByteSweep<D>& sweep, PairBuffer& pairs) {
  if (sweep.is_short && hn::Lanes(Bytes()) <= 32) {
    sweep.is_dense ? compare_dense<32>(leaf, sweep, pairs) : compare_all<32>(leaf, sweep, pairs);
  } else {
    sweep.is_dense ? compare_dense<64>(leaf, sweep, pairs) : compare_all<64>(leaf, sweep, pairs);
  }
}

template <int D>
HWY_INLINE void find_pairs(const LeafView<D>& leaf, ByteSweep<D>& sweep, PairBuffer& pairs) {
  sweep.make_room(leaf.size());
  sweep.is_dense = false;
  const ByteScale<D> scale = make_byte_scale(leaf);
  const std::array<float, D> length = make_keys(leaf, scale, sweep);
  if (lie_in_small_clumps<D>(length, sweep, leaf.size())) return sweep_floats(leaf, sweep, pairs);
  choose_axis(leaf.size(), length, sweep);
  order_entries(leaf, scale, sweep);
  const bool is_counted = may_be_dense(leaf.size(), length, static_cast<std::size_t>(sweep.axis));
  if (is_counted || may_be_clumped(leaf.size(), length)) {
    const RowSample rows = sample_rows(sweep, static_cast<std::uint32_t>(leaf.size()));
    const bool is_clumped = rows.all_at_end > tuning::kClumped;
    sweep.is_clumped |= is_clumped;
    if (is_clumped && divide_clumps(leaf, sweep)) return;
    if (is_counted || is_clumped) {
      const Comparison comparison = comparison_by_rows(leaf, scale, rows, sweep);
      if (comparison == Comparison::floats) return sweep_floats(leaf, sweep, pairs);
      sweep.is_dense = comparison == Comparison::dense_bytes;
    }
  }
  compare_bytes(leaf, sweep, pairs);
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
  if (planes.size() < stride * 2 * D) resize_list(planes, stride * 2 * D);
  resize_list(keys, n);
  resize_list(sorted_keys, n);
  resize_list(order, n);
}

template <int D>
void ByteSweep<D>::find(const LeafView<D>& leaf, PairBuffer& pairs) {
  clumps.clear();
  is_clumped = false;
  for (const LeafView<D>* part = &leaf; part != nullptr; part = clumps.next()) {
    if constexpr (D == 2) {
      HWY_DYNAMIC_DISPATCH(find_2)(*part, *this, pairs);
    } else {
      HWY_DYNAMIC_DISPATCH(find_3)(*part, *this, pairs);
    }
  }
}

template class ByteSweep<2>;
template class ByteSweep<3>;

}  // namespace kerf
#endif
