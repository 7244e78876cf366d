// The comparison of a leaf's bytes in their order, for each of the machine's kinds of vectors: included once
// for each by the kernels (Highway's foreach_target), so there is no `#pragma once`.
#if defined(KERF_COMPARE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KERF_COMPARE_INL_H
#undef KERF_COMPARE_INL_H
#else
#define KERF_COMPARE_INL_H
#endif

#include <cstddef>
#include <cstdint>

#include "core/kernels/byte_sweep.h"
#include "core/kernels/findings-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

/// A leaf's bytes in the order of the sweep, and the entry that is compared.
template <int D>
struct Ordered {
  Probe<D - 1> probe;  ///< the entry, on the axes that the order leaves open
  const std::uint8_t* own_min;
  const std::uint8_t* own_max;
  const std::uint16_t* stops;
  const std::uint32_t* ends;  ///< [q]: entries that begin before step q

  HWY_INLINE explicit Ordered(ByteSweep<D>& sweep)
      : own_min(sweep.plane(static_cast<std::size_t>(sweep.axis))),
        own_max(sweep.plane(static_cast<std::size_t>(D + sweep.axis))),
        stops(sweep.stops.data()),
        ends(sweep.ends.data()) {
    for (int k = 0; k < D - 1; ++k) {
      const auto other = static_cast<std::size_t>((sweep.axis + 1 + k) % D);
      probe.other_min[k] = sweep.plane(other);
      probe.other_max[k] = sweep.plane(D + other);
    }
  }
  HWY_INLINE void seek(std::uint32_t i) {
    for (int k = 0; k < D - 1; ++k) {
      probe.min[k] = hn::Set(Bytes(), probe.other_min[k][i]);
      probe.max[k] = hn::Set(Bytes(), probe.other_max[k][i]);
    }
  }
  /// Behind the entries that may begin before entry i ends.
  [[nodiscard]] HWY_INLINE std::uint32_t end(std::uint32_t i) const { return ends[stops[i] + 1U]; }
  [[nodiscard]] HWY_INLINE std::uint32_t sure_end(std::uint32_t i) const { return ends[stops[i]]; }
};

/// Not inlined, and takes the findings by value: the loop that calls it, once in hundreds of findings, then
/// keeps everything in registers.
template <int D>
HWY_NOINLINE void confirm_in(const LeafView<D>& leaf, const std::uint32_t* order, Found found,
                             PairBuffer& pairs) {
  const auto entry = [boxes = leaf.boxes.data(), objects = leaf.objects.data(),
                      apart = leaf.apart.data()](std::uint32_t place) {
    return EntryRef<D>{boxes[place], objects[place].value, apart[place]};
  };
  const auto nth = [order, entry](std::uint32_t k) { return entry(order[k]); };
  confirm<D>(found, entry, nth, pairs);
}

/// Compares each entry with those behind it that begin before it ends.
template <std::uint32_t Row, int D>
HWY_INLINE void compare_all(const LeafView<D>& leaf, ByteSweep<D>& sweep, PairBuffer& pairs) {
  const auto n = static_cast<std::uint32_t>(leaf.size());
  Ordered<D> ordered(sweep);
  const std::uint32_t* const order = sweep.order.data();
  Found found(sweep.found);
  for (std::uint32_t i = 0; i + 1 < n; ++i) {
    ordered.seek(i);
    const std::uint32_t end = ordered.end(i);
    for (std::uint32_t j = i + 1; j < end; j += Row) {
      found.add(overlap_bits<Row>(ordered.probe, j) & first_bits<Row>(end - j), order[i], j);
      if (!found.is_full()) continue;
      confirm_in<D>(leaf, order, found, pairs);
      found.clear();
    }
  }
  confirm_in<D>(leaf, order, found, pairs);
}

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
