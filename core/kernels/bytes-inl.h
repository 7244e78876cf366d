// Boxes as bytes, for each of the machine's kinds of vectors: included once for each by the kernels
// (Highway's foreach_target), so there is no `#pragma once`.
#if defined(KERF_BYTES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KERF_BYTES_INL_H
#undef KERF_BYTES_INL_H
#else
#define KERF_BYTES_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cfloat>
#include <cstdint>

#include "core/base/sample_place.h"
#include "core/kernels/leaf_view.h"
#include "core/kernels/packed-inl.h"
#include "core/kernels/sweep_tuning.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Bytes = hn::CappedTag<std::uint8_t, 64>;

/// A scale in vectors.
template <int D>
struct ByteMap {
  Packed<D> origin;
  Packed<D> scale;

  HWY_INLINE explicit ByteMap(const ByteScale<D>& bytes)
      : origin(load(bytes.origin)), scale(load(bytes.scale)) {}

  /// Each end on 0 .. 255.
  [[nodiscard]] HWY_INLINE Packed<D> operator()(const PackedBox<D>& box) const {
    const typename Packed<D>::Lanes lanes;
    Packed<D> ends = load(box);
    for (std::size_t k = 0; k < Packed<D>::kParts; ++k) {
      const auto scaled = hn::Mul(hn::Sub(ends.part[k], origin.part[k]), scale.part[k]);
      ends.part[k] = hn::Min(hn::Max(scaled, hn::Zero(lanes)), hn::Set(lanes, 255.0F));
    }
    return ends;
  }
};

using tuning::kChains;

/// Calls `work(i, chain)` for each i below n, in order.
template <class Work>
HWY_INLINE void in_chains(std::size_t n, Work work) {
  std::size_t i = 0;
  for (; i + kChains <= n; i += kChains)
    for (std::size_t chain = 0; chain < kChains; ++chain) work(i + chain, chain);
  for (; i < n; ++i) work(i, 0);
}

/// The greatest beginning along each axis, and the least end.
template <int D>
HWY_INLINE PackedBox<D> greatest_of_lanes(const std::vector<PackedBox<D>>& boxes) {
  Packed<D> greatest[kChains];
  for (Packed<D>& chain : greatest) chain = all_lanes<D>(-FLT_MAX);
  const auto take = [](const Packed<D>& from, Packed<D>& to) HWY_ATTR {
    for (std::size_t k = 0; k < Packed<D>::kParts; ++k) to.part[k] = hn::Max(to.part[k], from.part[k]);
  };
  in_chains(boxes.size(),
            [&](std::size_t i, std::size_t chain) HWY_ATTR { take(load(boxes[i]), greatest[chain]); });
  for (std::size_t chain = 1; chain < kChains; ++chain) take(greatest[chain], greatest[0]);
  PackedBox<D> result;
  store(greatest[0], result);
  return result;
}

/// The same of a sample, but the second greatest and the second least.
template <int D>
HWY_INLINE PackedBox<D> second_of_lanes(const std::vector<PackedBox<D>>& boxes) {
  Packed<D> first = all_lanes<D>(-FLT_MAX);
  Packed<D> second = first;
  for (std::uint32_t i = 0; i < tuning::kScaleSample; ++i) {
    const Packed<D> box = load(boxes[sample_place(i, boxes.size())]);
    for (std::size_t k = 0; k < Packed<D>::kParts; ++k) {
      second.part[k] = hn::Max(second.part[k], hn::Min(first.part[k], box.part[k]));
      first.part[k] = hn::Max(first.part[k], box.part[k]);
    }
  }
  PackedBox<D> result;
  store(second, result);
  return result;
}

/// Draws in ends that lie far from nearly all boxes, which would else share one byte.
template <int D>
HWY_INLINE void leave_out_far(const std::vector<PackedBox<D>>& boxes, PackedBox<D>& greatest) {
  constexpr std::size_t kHalf = PackedBox<D>::kHalf;
  const PackedBox<D> most = second_of_lanes<D>(boxes);
  for (std::size_t axis = 0; axis < D; ++axis) {
    const float stretch = most.lane[axis] + most.lane[kHalf + axis];
    if (stretch <= 0) continue;
    for (const std::size_t end : {axis, kHalf + axis})
      greatest.lane[end] = std::min(greatest.lane[end], most.lane[end] + stretch);
  }
}

template <int D>
HWY_INLINE ByteScale<D> make_byte_scale(const LeafView<D>& leaf) {
  constexpr std::size_t kHalf = PackedBox<D>::kHalf;
  PackedBox<D> greatest = greatest_of_lanes<D>(leaf.boxes);
  if (leaf.size() >= tuning::kLeastSampled) leave_out_far(leaf.boxes, greatest);
  ByteScale<D> bytes;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const float least_max = -greatest.lane[kHalf + axis];
    const float stretch = greatest.lane[axis] - least_max;
    // Where all boxes share a point, it lies between all beginnings and all ends. Such an axis separates
    // nothing, and no box may look short on it. An infinite stretch gives 0; 0 * inf never arises.
    bytes.origin.lane[axis] = stretch > 0 ? least_max : 0.5F * greatest.lane[axis] + 0.5F * least_max;
    bytes.scale.lane[axis] = stretch > 0 ? std::clamp(255.0F / stretch, FLT_MIN, 1e30F) : 1e30F;
    bytes.origin.lane[kHalf + axis] = -bytes.origin.lane[axis];
    bytes.scale.lane[kHalf + axis] = -bytes.scale.lane[axis];
  }
  return bytes;
}

/// Mapped ends to the nearest bytes: those of min in the low half, those of max in the high one.
template <int D>
HWY_INLINE ByteKey<D> byte_key(const Packed<D>& mapped) {
  using Lanes = typename Packed<D>::Lanes;
  const hn::RebindToSigned<Lanes> ints;
  const hn::Rebind<std::uint8_t, Lanes> bytes;
  ByteKey<D> key = 0;
  auto* const out = reinterpret_cast<std::uint8_t*>(&key);
  for (std::size_t k = 0; k < Packed<D>::kParts; ++k) {
    // Added to 2^23, a number is rounded to an integer, which is then the low bits of the sum. (Highway's
    // TruncateTo from eight lanes is wrong on AVX3_DL in version 1.0.3.)
    const auto sum = hn::BitCast(ints, hn::Add(mapped.part[k], hn::Set(Lanes(), 8388608.0F)));
    hn::StoreU(hn::DemoteTo(bytes, hn::And(sum, hn::Set(ints, 255))), bytes, out + k * Packed<D>::kLanes);
  }
  return key;
}

/// One entry, spread over whole vectors, and the planes with which it is compared: A axes of both.
template <int A>
struct Probe {
  const std::uint8_t* other_min[A];
  const std::uint8_t* other_max[A];
  hn::Vec<Bytes> min[A];
  hn::Vec<Bytes> max[A];
};

/// Zero in the lanes of the entries from `at` on that the probe overlaps on its axes.
template <int A>
HWY_INLINE hn::Vec<Bytes> lanes_beyond(const Probe<A>& probe, std::size_t at) {
  const Bytes bytes;
  auto beyond = hn::Zero(bytes);
  for (int k = 0; k < A; ++k) {
    const auto other_max = hn::LoadU(bytes, probe.other_max[k] + at);
    const auto other_min = hn::LoadU(bytes, probe.other_min[k] + at);
    beyond = hn::Or(beyond, hn::SaturatedSub(probe.min[k], other_max));
    beyond = hn::Or(beyond, hn::SaturatedSub(other_min, probe.max[k]));
  }
  return beyond;
}

/// Bit k: lane k is zero.
HWY_INLINE std::uint64_t bits_of_zeros(hn::Vec<Bytes> lanes) {
  std::uint64_t bits = 0;
  hn::StoreMaskBits(Bytes(), hn::Eq(lanes, hn::Zero(Bytes())), reinterpret_cast<std::uint8_t*>(&bits));
  return bits;
}

/// Bit k: the probe overlaps entry j + k on the probe's axes.
template <std::uint32_t Row = 64, int A>
HWY_INLINE std::uint64_t overlap_bits(const Probe<A>& probe, std::size_t j) {
  std::uint64_t result = 0;
  for (std::size_t lane = 0; lane < Row; lane += hn::Lanes(Bytes()))
    result |= bits_of_zeros(lanes_beyond(probe, j + lane)) << lane;
  return result;
}

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
