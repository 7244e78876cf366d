// The comparison of bytes in leaves where boxes lie dense, for each of the machine's kinds of vectors:
// included once for each by the kernels (Highway's foreach_target), so there is no `#pragma once`.
#if defined(KERF_COMPARE_DENSE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KERF_COMPARE_DENSE_INL_H
#undef KERF_COMPARE_DENSE_INL_H
#else
#define KERF_COMPARE_DENSE_INL_H
#endif

#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/kernels/compare-inl.h"
#include "core/kernels/sure_pairs-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

/// An exclusion mask folded into a byte. Entries whose bytes have no common bit have no common bit in their
/// masks.
constexpr std::uint8_t fold(DepthMask apart) {
  apart |= apart >> 32U;
  apart |= apart >> 16U;
  apart |= apart >> 8U;
  return static_cast<std::uint8_t>(apart);
}

/// Copies objects and folded exclusion masks in the order of the sweep. Returns whether the bytes decide
/// exclusion: no two bits in use fall on the same one.
template <int D>
HWY_INLINE bool copy_in_order(const LeafView<D>& leaf, ByteSweep<D>& sweep) {
  sweep.objects.resize(leaf.size() + ByteSweep<D>::kPad);
  sweep.apart.resize(leaf.size() + ByteSweep<D>::kPad);
  DepthMask all = 0;
  for (std::size_t k = 0; k < leaf.size(); ++k) {
    const std::uint32_t place = sweep.order[k];
    sweep.objects[k] = leaf.objects[place].value;
    sweep.apart[k] = fold(leaf.apart[place]);
    all |= leaf.apart[place];
  }
  return std::popcount(fold(all)) == std::popcount(all);
}

/// What bytes show of 64 entries that begin before another one ends.
struct RowBits {
  std::uint64_t maybe = 0;  ///< they may overlap
  std::uint64_t sure = 0;   ///< they are pairs
  std::uint64_t here = 0;   ///< their masks exclude nothing, as far as the bytes show
};

/// A dense leaf in its order. The map to bytes is monotone: a smaller byte stands for a smaller float.
template <int D>
struct Dense : Ordered<D> {
  const std::uint8_t* others_apart;
  hn::Vec<Bytes> begin;
  hn::Vec<Bytes> apart;

  HWY_INLINE explicit Dense(ByteSweep<D>& sweep)
      : Ordered<D>(sweep),
        others_apart(sweep.apart.data()),
        begin(hn::Zero(Bytes())),
        apart(hn::Zero(Bytes())) {}

  HWY_INLINE void seek(std::uint32_t i) {
    Ordered<D>::seek(i);
    begin = hn::Set(Bytes(), this->own_min[i]);
    apart = hn::Set(Bytes(), others_apart[i]);
  }
  [[nodiscard]] HWY_INLINE RowBits row(std::uint32_t j) const {
    const Bytes bytes;
    RowBits row;
    std::uint64_t unsure = 0;
    for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(bytes)) {
      const auto common = hn::And(apart, hn::LoadU(bytes, others_apart + j + lane));
      row.maybe |= bits_of_zeros(lanes_beyond(this->probe, j + lane)) << lane;
      row.here |= bits_of_zeros(common) << lane;
      unsure |= bits_of_zeros(lanes_within(j + lane)) << lane;
    }
    row.sure = row.here & ~unsure;
    return row;
  }

 private:
  /// More than zero in the lanes of the pairs that bytes alone prove.
  [[nodiscard]] HWY_INLINE hn::Vec<Bytes> lanes_within(std::size_t at) const {
    const Bytes bytes;
    auto within = hn::SaturatedSub(hn::LoadU(bytes, this->own_max + at), begin);
    for (int k = 0; k < D - 1; ++k) {
      const auto other_max = hn::LoadU(bytes, this->probe.other_max[k] + at);
      const auto other_min = hn::LoadU(bytes, this->probe.other_min[k] + at);
      within = hn::Min(within, hn::SaturatedSub(other_max, this->probe.min[k]));
      within = hn::Min(within, hn::SaturatedSub(this->probe.max[k], other_min));
    }
    return within;
  }
};

/// Compares as `compare_all` does, and writes at once the pairs that need no confirmation. The other pairs
/// follow behind all of those, so that the order does not depend on the time of their confirmation.
template <int D>
HWY_INLINE void compare_dense(const LeafView<D>& leaf, ByteSweep<D>& sweep, PairBuffer& pairs) {
  const auto n = static_cast<std::uint32_t>(leaf.size());
  const std::uint64_t unknown = copy_in_order(leaf, sweep) ? 0 : UINT64_MAX;
  Dense<D> dense(sweep);
  const std::uint32_t* const objects = sweep.objects.data();
  const std::uint32_t* const order = sweep.order.data();
  sweep.unsure.clear();
  Found found(sweep.found);
  for (std::uint32_t i = 0; i + 1 < n; ++i) {
    dense.seek(i);
    const std::uint32_t sure_end = dense.sure_end(i);
    const std::uint32_t end = dense.end(i);
    Pair* const begin = pairs.reserve(end - i + kRowRoom);
    Pair* out = begin;
    for (std::uint32_t j = i + 1; j < end; j += 64) {
      const RowBits row = dense.row(j);
      const std::uint64_t sure = row.sure & first_bits(sure_end > j ? sure_end - j : 0);
      const std::uint64_t others = row.maybe & ~sure & (row.here | unknown) & first_bits(end - j);
      out = write_row(objects[i], objects + j, sure, out);
      found.add(others, order[i], j);
      if (!found.is_full()) continue;
      confirm_in<D>(leaf, order, found, sweep.unsure);
      found.clear();
    }
    pairs.commit(static_cast<std::size_t>(out - begin));
  }
  confirm_in<D>(leaf, order, found, sweep.unsure);
  pairs.append(std::as_const(sweep.unsure).all());
}

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
