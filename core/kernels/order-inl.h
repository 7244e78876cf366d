// The order in which a leaf's bytes are compared, for each of the machine's kinds of vectors: included once
// for each by the kernels (Highway's foreach_target), so there is no `#pragma once`.
#if defined(KERF_ORDER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KERF_ORDER_INL_H
#undef KERF_ORDER_INL_H
#else
#define KERF_ORDER_INL_H
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "core/kernels/byte_sweep.h"
#include "core/kernels/bytes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

/// Fills `fine` with the steps of all entries, by a map that is monotone, as that to bytes is.
template <int D>
HWY_INLINE void make_fine_keys(const LeafView<D>& leaf, const ByteScale<D>& scale, ByteSweep<D>& sweep) {
  constexpr auto kLast = static_cast<float>(tuning::kFineSteps - 1);
  const auto axis = static_cast<std::size_t>(sweep.axis);
  const float origin = scale.origin.lane[axis];
  const float steps = scale.scale.lane[axis] * (kLast / 255);
  const auto step = [=](float x) HWY_ATTR {
    const float scaled = std::min(std::max((x - origin) * steps, 0.0F), kLast);
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(scaled));
  };
  resize_list(sweep.fine, leaf.size());
  const PackedBox<D>* const boxes = leaf.boxes.data();
  std::uint32_t* const HWY_RESTRICT fine = sweep.fine.data();
  for (std::size_t i = 0; i < leaf.size(); ++i)
    fine[i] = step(boxes[i].lane[axis]) | step(-boxes[i].lane[PackedBox<D>::kHalf + axis]) << 16U;
}

/// Counts the entries that begin at each step, and writes their places and bytes in that order. `begin(i)` is
/// the step at which an entry begins; `put(place, i)` is called for each. The order is stable. The entries
/// stay where they are: copying them costs more than finding them by their places.
template <int D, class Begin, class Put>
HWY_INLINE void order_by(ByteSweep<D>& sweep, std::size_t n, std::size_t steps, Begin begin, Put put) {
  const ByteKey<D>* const keys = sweep.keys.data();
  std::uint32_t* const ends = sweep.ends.data();
  std::fill_n(ends, steps + 1, 0U);
  for (std::size_t i = 0; i < n; ++i) ++ends[begin(i) + 1];
  for (std::size_t q = 1; q <= steps; ++q) ends[q] += ends[q - 1];
  std::uint32_t next[tuning::kFineSteps];
  std::copy_n(ends, steps, next);
  std::uint32_t* const HWY_RESTRICT order = sweep.order.data();
  ByteKey<D>* const HWY_RESTRICT sorted_keys = sweep.sorted_keys.data();
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t place = next[begin(i)]++;
    order[place] = static_cast<std::uint32_t>(i);
    sorted_keys[place] = keys[i];
    put(place, i);
  }
}

/// Orders the entries along the axis, by fine steps or by bytes, which are 256 steps.
template <int D>
HWY_INLINE void order_entries(const LeafView<D>& leaf, const ByteScale<D>& scale, ByteSweep<D>& sweep) {
  const std::size_t n = leaf.size();
  resize_list(sweep.stops, n);
  std::uint16_t* const HWY_RESTRICT stops = sweep.stops.data();
  const ByteKey<D>* const keys = sweep.keys.data();
  const unsigned byte_of_axis = 8U * static_cast<unsigned>(sweep.axis);
  if (sweep.is_fine) {
    make_fine_keys(leaf, scale, sweep);
    const std::uint32_t* const fine = sweep.fine.data();
    order_by(
        sweep, n, tuning::kFineSteps, [=](std::size_t i) HWY_ATTR { return fine[i] & 0xFFFFU; },
        [=](std::uint32_t place, std::size_t i)
            HWY_ATTR { stops[place] = static_cast<std::uint16_t>(fine[i] >> 16U); });
  } else {
    order_by(
        sweep, n, 256, [=](std::size_t i) HWY_ATTR { return (keys[i] >> byte_of_axis) & 255U; },
        [](std::uint32_t, std::size_t) HWY_ATTR {});
  }
  const ByteKey<D>* const sorted_keys = sweep.sorted_keys.data();
  for (unsigned k = 0; k < 2U * D; ++k) {
    const unsigned byte = 8U * (k < D ? k : k - D + PackedBox<D>::kHalf);
    std::uint8_t* const HWY_RESTRICT plane = sweep.plane(k);
    for (std::size_t i = 0; i < n; ++i) plane[i] = static_cast<std::uint8_t>(sorted_keys[i] >> byte);
  }
  if (sweep.is_fine) return;
  const std::uint8_t* const HWY_RESTRICT own_max = sweep.plane(static_cast<std::size_t>(D + sweep.axis));
  for (std::size_t i = 0; i < n; ++i) stops[i] = own_max[i];
}

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
