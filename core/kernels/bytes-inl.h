// Boxes as bytes, for each of the machine's kinds of vectors: included once for each by the kernels
// (Highway's foreach_target), so there is no `#pragma once`.
#if defined(KERF_BYTES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KERF_BYTES_INL_H
#undef KERF_BYTES_INL_H
#else
#define KERF_BYTES_INL_H
#endif

#include <hwy/highway.h>

#include <cfloat>
#include <cstdint>

#include "core/kernels/leaf_view.h"
#include "core/kernels/packed-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Bytes = hn::CappedTag<std::uint8_t, 64>;

/// The two ends of a box, each in the first D lanes.
struct Ends {
  Floats min;
  Floats minus_max;
};

template <int D>
HWY_INLINE Ends load_ends(const PackedBox<D>& box) {
  const Four four;
  const Floats first = hn::Load(four, box.lane.data());
  if constexpr (D == 2) {
    return {first, hn::Shuffle1032(first)};
  } else {
    return {first, hn::Load(four, box.lane.data() + 4)};
  }
}

/// The monotone map of a leaf onto bytes: what lies below the least end of a box, or above the greatest
/// beginning, overlaps in any case, so that only the stretch between is worth telling apart.
struct ByteMap {
  Floats origin;
  Floats scale;

  [[nodiscard]] HWY_INLINE Floats operator()(Floats x) const {
    const Four four;
    const Floats scaled = hn::Mul(hn::Sub(x, origin), scale);
    return hn::Min(hn::Max(scaled, hn::Zero(four)), hn::Set(four, 255.0F));
  }
};

template <int D>
HWY_INLINE ByteMap make_byte_map(const LeafView<D>& leaf) {
  const Four four;
  Floats greatest_min = hn::Set(four, -FLT_MAX);
  Floats least_max = hn::Set(four, FLT_MAX);
  for (const PackedBox<D>& box : leaf.boxes) {
    const Ends ends = load_ends(box);
    greatest_min = hn::Max(greatest_min, ends.min);
    least_max = hn::Min(least_max, hn::Neg(ends.minus_max));
  }
  const Floats scale = hn::Div(hn::Set(four, 255.0F), hn::Sub(greatest_min, least_max));
  // A stretch of no length gives infinity or less than nothing, an endless one nothing; 0 * inf never arises.
  return {least_max, hn::Min(hn::Max(scale, hn::Set(four, FLT_MIN)), hn::Set(four, 1e30F))};
}

/// Four mapped coordinates as bytes, the first one lowest.
HWY_INLINE std::uint32_t four_bytes(Floats mapped) {
  const hn::FixedTag<std::int32_t, 4> ints;
  const hn::FixedTag<std::uint8_t, 4> bytes;
  alignas(16) std::uint32_t word[4];
  hn::Store(hn::DemoteTo(bytes, hn::ConvertTo(ints, mapped)), bytes, reinterpret_cast<std::uint8_t*>(word));
  return word[0];
}

/// The bytes of mapped ends: min of each axis in the low half, max in the high one.
template <int D>
HWY_INLINE ByteKey<D> byte_key(Floats min, Floats max) {
  if constexpr (D == 2) {
    return (four_bytes(min) & 0xffffU) | (four_bytes(max) << 16U);
  } else {
    return four_bytes(min) | (ByteKey<D>{four_bytes(max)} << 32U);
  }
}

/// One entry, spread over whole vectors, and the planes with which it is compared: A axes of both.
template <int A>
struct Probe {
  const std::uint8_t* other_min[A];
  const std::uint8_t* other_max[A];
  hn::Vec<Bytes> min[A];
  hn::Vec<Bytes> max[A];
};

/// Bit k: the probe overlaps entry j + k on the probe's axes.
template <int A>
HWY_INLINE std::uint64_t overlap_bits(const Probe<A>& probe, std::size_t j) {
  const Bytes bytes;
  const std::size_t lanes = hn::Lanes(bytes);
  std::uint64_t result = 0;
  for (std::size_t lane = 0; lane < 64; lane += lanes) {
    auto beyond = hn::Zero(bytes);
    for (int k = 0; k < A; ++k) {
      const auto other_max = hn::LoadU(bytes, probe.other_max[k] + j + lane);
      const auto other_min = hn::LoadU(bytes, probe.other_min[k] + j + lane);
      beyond = hn::Or(beyond, hn::SaturatedSub(probe.min[k], other_max));
      beyond = hn::Or(beyond, hn::SaturatedSub(other_min, probe.max[k]));
    }
    std::uint64_t part = 0;
    hn::StoreMaskBits(bytes, hn::Eq(beyond, hn::Zero(bytes)), reinterpret_cast<std::uint8_t*>(&part));
    result |= part << lane;
  }
  return result;
}

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
