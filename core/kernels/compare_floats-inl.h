// The comparison of a leaf's floats in their order, for each of the machine's kinds of vectors: included once
// for each by the kernels (Highway's foreach_target), so there is no `#pragma once`.
#if defined(KERF_COMPARE_FLOATS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KERF_COMPARE_FLOATS_INL_H
#undef KERF_COMPARE_FLOATS_INL_H
#else
#define KERF_COMPARE_FLOATS_INL_H
#endif

#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/base/sample_place.h"
#include "core/kernels/compare_dense-inl.h"
#include "core/kernels/order_floats-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

using FloatLanes = hn::CappedTag<Scalar, 16>;

/// Bit k: the folded masks of entries i and j + k have no common bit, so their masks have none.
template <std::uint32_t Row>
HWY_INLINE std::uint64_t free_bits(const FloatSweep& sweep, std::uint32_t i, std::uint32_t j) {
  const Bytes bytes;
  const auto own = hn::Set(bytes, sweep.folded[i]);
  std::uint64_t bits = 0;
  for (std::size_t lane = 0; lane < Row; lane += hn::Lanes(bytes))
    bits |= bits_of_zeros(hn::And(own, hn::LoadU(bytes, sweep.folded.data() + j + lane))) << lane;
  return bits;
}

/// Writes the findings that no mask excludes.
HWY_NOINLINE void write_found(const FloatSweep& sweep, Found found, PairBuffer& pairs) {
  const std::uint32_t* const objects = sweep.objects.data();
  const DepthMask* const apart = sweep.apart.data();
  Pair* const begin = pairs.reserve(found.count());
  Pair* HWY_RESTRICT out = begin;
  Found::Walk walk(found);
  for (std::size_t left = found.count(); left > 0; --left, walk.advance()) {
    const std::uint32_t i = walk.i();
    const std::uint32_t j = walk.j();
    *out = {ObjectId{objects[i]}, ObjectId{objects[j]}};
    out += static_cast<std::ptrdiff_t>((apart[i] & apart[j]) == 0);
  }
  order_ids(begin, static_cast<std::size_t>(out - begin));
  pairs.commit(static_cast<std::size_t>(out - begin));
}

/// A leaf's floats in their order, and the entry that is compared.
template <int D>
struct OrderedFloats {
  hn::Vec<FloatLanes> own[2 * D];
  const Scalar* planes[2 * D];
  std::uint32_t count;

  HWY_INLINE explicit OrderedFloats(FloatSweep& sweep)
      : count(static_cast<std::uint32_t>(sweep.order.items.size())) {
    for (std::size_t k = 0; k < 2 * D; ++k) planes[k] = sweep.plane(k);
  }
  HWY_INLINE void seek(std::uint32_t i) {
    for (std::size_t k = 0; k < 2 * D; ++k) own[k] = hn::Set(FloatLanes(), planes[k][i]);
  }
  /// Whether entry k begins before entry i ends.
  [[nodiscard]] HWY_INLINE bool is_reached(std::uint32_t i, std::uint32_t k) const {
    return k < count && planes[0][k] <= planes[1][i];
  }
  /// Bit k: the entry overlaps entry j + k, which does not begin before it.
  template <std::uint32_t Row>
  [[nodiscard]] HWY_INLINE std::uint64_t row(std::uint32_t j) const {
    const FloatLanes lanes;
    std::uint64_t bits = 0;
    for (std::size_t lane = 0; lane < Row; lane += hn::Lanes(lanes)) {
      const auto other = [&](std::size_t k) HWY_ATTR { return hn::LoadU(lanes, planes[k] + j + lane); };
      auto hit = hn::Le(other(0), own[1]);
      for (std::size_t k = 2; k < 2 * D; k += 2)
        hit = hn::And(hit, hn::And(hn::Le(other(k), own[k + 1]), hn::Ge(other(k + 1), own[k])));
      std::uint64_t some = 0;
      hn::StoreMaskBits(lanes, hit, reinterpret_cast<std::uint8_t*>(&some));
      bits |= some << lane;
    }
    return bits & first_bits<Row>(count - j);  // a box without end reaches beyond the last
  }
};

inline constexpr std::uint32_t kFloatRow = 32;

/// Whether many of the entries behind one overlap it, in a few rows.
template <int D>
HWY_INLINE bool are_crowded(OrderedFloats<D>& ordered, std::uint32_t n) {
  int found = 0;
  for (std::uint32_t k = 0; k < tuning::kDensityRows; ++k) {
    const auto i = static_cast<std::uint32_t>(sample_place(k, n - 1));
    ordered.seek(i);
    found += std::popcount(ordered.template row<kFloatRow>(i + 1));
  }
  return static_cast<float>(found) > tuning::kSurePerRow * static_cast<float>(tuning::kDensityRows);
}

/// Compares each entry with those behind it that begin before it ends.
template <int D>
HWY_INLINE void compare_sparse(OrderedFloats<D>& ordered, FloatSweep& sweep, Found& found, std::uint32_t n,
                               PairBuffer& pairs) {
  for (std::uint32_t i = 0; i + 1 < n; ++i) {
    ordered.seek(i);
    std::uint32_t j = i + 1;
    do {
      found.add(ordered.template row<kFloatRow>(j), i, j);
      if (found.is_full()) {
        write_found(sweep, found, pairs);
        found.clear();
      }
      j += kFloatRow;
    } while (ordered.is_reached(i, j - 1));
  }
  write_found(sweep, found, pairs);
}

/// The same, and writes at once the pairs that no mask can exclude. The others follow behind all of those, so
/// that the order does not depend on the time at which masks are looked at.
template <int D>
HWY_INLINE void compare_crowded(OrderedFloats<D>& ordered, FloatSweep& sweep, Found& found, std::uint32_t n,
                                PairBuffer& pairs) {
  const std::uint64_t unknown = sweep.folds_decide ? 0 : ~std::uint64_t{0};
  sweep.excluded.clear();
  for (std::uint32_t i = 0; i + 1 < n; ++i) {
    ordered.seek(i);
    Pair* const begin = pairs.reserve(n - i + kRowRoom);
    RowWriter rows(sweep.objects[i], begin, sweep.others.data());
    std::uint32_t j = i + 1;
    do {
      const std::uint64_t bits = ordered.template row<kFloatRow>(j);
      const std::uint64_t free = bits & free_bits<kFloatRow>(sweep, i, j);
      rows.template add<kFloatRow>(sweep.objects.data() + j, free, n - j);
      found.add(bits & ~free & unknown, i, j);
      if (found.is_full()) {
        write_found(sweep, found, sweep.excluded);
        found.clear();
      }
      j += kFloatRow;
    } while (ordered.is_reached(i, j - 1));
    pairs.commit(static_cast<std::size_t>(rows.finish() - begin));
  }
  write_found(sweep, found, sweep.excluded);
  pairs.append(std::as_const(sweep.excluded).all());
}

/// Appends the pairs of a leaf of at least two entries, swept along `axis`.
template <int D>
HWY_NOINLINE void compare_floats(const LeafView<D>& leaf, std::size_t axis, FloatSweep& sweep, Findings& room,
                                 PairBuffer& pairs) {
  order_by_floats(leaf, axis, sweep);
  const auto n = static_cast<std::uint32_t>(leaf.size());
  OrderedFloats<D> ordered(sweep);
  Found found(room);
  are_crowded(ordered, n) ? compare_crowded(ordered, sweep, found, n, pairs)
                          : compare_sparse(ordered, sweep, found, n, pairs);
}

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
