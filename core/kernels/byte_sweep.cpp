#include "core/kernels/byte_sweep.h"

#include <algorithm>
#include <bit>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/byte_sweep.cpp"
#include <hwy/foreach_target.h>

#include "core/kernels/bytes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

/// The keys of all boxes; returns the sums of their lengths in bytes. In 2D one vector has both ends: the map
/// of what is turned is the turned map, to the last bit.
template <int D>
HWY_INLINE Floats fill_keys(const LeafView<D>& leaf, const ByteMap& map, ByteSweep<D>& sweep) {
  const Four four;
  Floats sums = hn::Zero(four);
  if constexpr (D == 2) {
    const ByteMap both{hn::ConcatLowerLower(four, hn::Neg(map.origin), map.origin),
                       hn::ConcatLowerLower(four, hn::Neg(map.scale), map.scale)};
    for (std::size_t i = 0; i < leaf.size(); ++i) {
      const Floats ends = both(hn::Load(four, leaf.boxes[i].lane.data()));
      sums = hn::Add(sums, ends);
      sweep.keys[i] = four_bytes(ends);
    }
    return hn::Sub(hn::Shuffle1032(sums), sums);
  } else {
    for (std::size_t i = 0; i < leaf.size(); ++i) {
      const Ends ends = load_ends(leaf.boxes[i]);
      const Floats min = map(ends.min);
      const Floats max = map(hn::Neg(ends.minus_max));
      sums = hn::Add(sums, hn::Sub(max, min));
      sweep.keys[i] = byte_key<D>(min, max);
    }
    return sums;
  }
}

/// Fills `keys` and chooses the axis along which the boxes are shortest.
template <int D>
HWY_INLINE void make_keys(const LeafView<D>& leaf, ByteSweep<D>& sweep) {
  alignas(16) float length[4];
  hn::Store(fill_keys(leaf, make_byte_map(leaf), sweep), Four(), length);
  sweep.axis = 0;
  for (int axis = 1; axis < D; ++axis)
    if (length[axis] < length[sweep.axis]) sweep.axis = axis;
}

/// Counts the entries that begin at each byte of the axis, and writes them in that order; equal ones stay in
/// the order in which they came.
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
  PackedBox<D>* const HWY_RESTRICT boxes = sweep.sorted.boxes.data();
  ObjectId* const HWY_RESTRICT objects = sweep.sorted.objects.data();
  DepthMask* const HWY_RESTRICT apart = sweep.sorted.apart.data();
  ByteKey<D>* const HWY_RESTRICT sorted_keys = sweep.sorted_keys.data();
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t place = next[(keys[i] >> shift) & 255U]++;
    boxes[place] = leaf.boxes[i];
    objects[place] = leaf.objects[i];
    apart[place] = leaf.apart[i];
    sorted_keys[place] = keys[i];
  }
  for (unsigned k = 0; k < 2U * D; ++k) {
    const unsigned byte = 8U * (k < D ? k : k - D + PackedBox<D>::kHalf);
    std::uint8_t* const HWY_RESTRICT plane = sweep.plane(k);
    for (std::size_t i = 0; i < n; ++i) plane[i] = static_cast<std::uint8_t>(sorted_keys[i] >> byte);
  }
}

/// The pair in canonical order, in a way of which no compiler makes a branch: nothing predicts whose id is
/// less.
HWY_INLINE Pair ordered_pair(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t swapped = (a ^ b) & (0U - static_cast<std::uint32_t>(a > b));
  return {ObjectId{a ^ swapped}, ObjectId{b ^ swapped}};
}

/// Confirms on the floats what the bytes have found. No branch depends on the outcome.
template <int D>
HWY_INLINE void confirm(const ByteSweep<D>& sweep, std::size_t count, PairBuffer& pairs) {
  Pair* const HWY_RESTRICT out = pairs.reserve(count);
  const auto* const found = sweep.found.data();
  const PackedBox<D>* const boxes = sweep.sorted.boxes.data();
  const DepthMask* const apart = sweep.sorted.apart.data();
  const ObjectId* const objects = sweep.sorted.objects.data();
  std::size_t written = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const auto [i, j] = found[k];
    const bool overlap = ends_overlap<D>(load_ends(boxes[i]), load_ends(boxes[j]));
    const bool here = (apart[i] & apart[j]) == 0;
    out[written] = ordered_pair(objects[i].value, objects[j].value);
    written += static_cast<std::size_t>(overlap & here);
  }
  pairs.commit(written);
}

/// As many of the lowest bits, or all.
HWY_INLINE std::uint64_t first_bits(std::uint32_t count) {
  return count < 64 ? (std::uint64_t{1} << count) - 1 : UINT64_MAX;
}

/// The number of the lowest bit; anything if there is none. To the compiler there is always one, or it would
/// make a branch for the other case, which nothing predicts.
HWY_INLINE std::uint64_t lowest_bit(std::uint64_t bits) {
  return static_cast<std::uint64_t>(std::countr_zero(bits | (std::uint64_t{1} << 63U)));
}

/// Writes (i, j + k) for each bit k and gives their number. Four are written whether they are there or not:
/// few rows have more, and the branch that tells is seldom mispredicted.
HWY_INLINE std::size_t list_bits(std::uint64_t bits, std::uint32_t i, std::uint32_t j, FoundAt* found) {
  const auto count = static_cast<std::size_t>(std::popcount(bits));
  const std::uint64_t first = i | std::uint64_t{j} << 32U;
  const auto write = [&](std::size_t k) {
    const std::uint64_t both = first + (lowest_bit(bits) << 32U);
    found[k] = {static_cast<std::uint32_t>(both), static_cast<std::uint32_t>(both >> 32U)};
    bits &= bits - 1;
  };
  for (std::size_t k = 0; k < 4; ++k) write(k);
  for (std::size_t k = 4; k < count; ++k) write(k);
  return count;
}

/// Compares each entry with those behind it that begin before it ends, on the axes that the order leaves
/// open.
template <int D>
HWY_INLINE void compare_all(ByteSweep<D>& sweep, PairBuffer& pairs) {
  const Bytes bytes;
  const auto n = static_cast<std::uint32_t>(sweep.sorted.size());
  Probe<D - 1> probe;
  for (int k = 0; k < D - 1; ++k) {
    const auto other = static_cast<std::size_t>((sweep.axis + 1 + k) % D);
    probe.other_min[k] = sweep.plane(other);
    probe.other_max[k] = sweep.plane(D + other);
  }
  const std::uint8_t* const own_max = sweep.plane(static_cast<std::size_t>(D + sweep.axis));
  const std::uint32_t* const ends = sweep.ends.data() + 1;
  auto* const HWY_RESTRICT found = sweep.found.data();
  std::size_t count = 0;
  for (std::uint32_t i = 0; i + 1 < n; ++i) {
    for (int k = 0; k < D - 1; ++k) {
      probe.min[k] = hn::Set(bytes, probe.other_min[k][i]);
      probe.max[k] = hn::Set(bytes, probe.other_max[k][i]);
    }
    const std::uint32_t end = ends[own_max[i]];
    for (std::uint32_t j = i + 1; j < end; j += 64) {
      count += list_bits(overlap_bits(probe, j) & first_bits(end - j), i, j, found + count);
      if (count < ByteSweep<D>::kConfirmAt) continue;
      confirm(sweep, count, pairs);
      count = 0;
    }
  }
  confirm(sweep, count, pairs);
}

template <int D>
HWY_INLINE void find_pairs(const LeafView<D>& leaf, ByteSweep<D>& sweep, PairBuffer& pairs) {
  sweep.make_room(leaf.size());
  make_keys(leaf, sweep);
  order_entries(leaf, sweep);
  compare_all(sweep, pairs);
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
  constexpr std::size_t kRow = 64;
  stride = n + kPad;
  if (planes.size() < stride * 2 * D) planes.resize(stride * 2 * D);
  found.resize(kConfirmAt + kRow + 4);
  keys.resize(n);
  sorted_keys.resize(n);
  sorted.resize(n);
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
