// The comparison of bytes in leaves where boxes lie dense, for each of the machine's kinds of vectors:
// included once for each by the kernels (Highway's foreach_target), so there is no `#pragma once`.
#if defined(KERF_COMPARE_DENSE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KERF_COMPARE_DENSE_INL_H
#undef KERF_COMPARE_DENSE_INL_H
#else
#define KERF_COMPARE_DENSE_INL_H
#endif

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/base/sample_place.h"
#include "core/kernels/compare-inl.h"
#include "core/kernels/sure_pairs-inl.h"
#include "core/kernels/sweep_tuning.h"

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
  sweep.others.resize(leaf.size() + kRowRoom);
  DepthMask all = 0;
  for (std::size_t k = 0; k < leaf.size(); ++k) {
    const std::uint32_t place = sweep.order[k];
    sweep.objects[k] = leaf.objects[place].value;
    sweep.apart[k] = fold(leaf.apart[place]);
    all |= leaf.apart[place];
  }
  return std::popcount(fold(all)) == std::popcount(all);
}

struct ProvedLanes {
  hn::Vec<Bytes> beyond;  ///< zero where boxes may overlap
  hn::Vec<Bytes> within;  ///< more than zero where they do, as bytes alone prove
};

/// What bytes prove of a leaf in its order. The map to bytes is monotone: a smaller byte stands for a smaller
/// float.
template <int D>
struct Proved : Ordered<D> {
  hn::Vec<Bytes> begin;

  HWY_INLINE explicit Proved(ByteSweep<D>& sweep) : Ordered<D>(sweep), begin(hn::Zero(Bytes())) {}

  HWY_INLINE void seek(std::uint32_t i) {
    Ordered<D>::seek(i);
    begin = hn::Set(Bytes(), this->own_min[i]);
  }
  /// The lanes of the entries from `at` on.
  [[nodiscard]] HWY_INLINE ProvedLanes lanes(std::size_t at) const {
    const Bytes bytes;
    ProvedLanes lanes{hn::Zero(bytes), hn::SaturatedSub(hn::LoadU(bytes, this->own_max + at), begin)};
    for (int k = 0; k < D - 1; ++k) {
      const auto other_max = hn::LoadU(bytes, this->probe.other_max[k] + at);
      lanes.beyond = hn::Or(lanes.beyond, hn::SaturatedSub(this->probe.min[k], other_max));
      lanes.within = hn::Min(lanes.within, hn::SaturatedSub(other_max, this->probe.min[k]));
      const auto other_min = hn::LoadU(bytes, this->probe.other_min[k] + at);
      lanes.beyond = hn::Or(lanes.beyond, hn::SaturatedSub(other_min, this->probe.max[k]));
      lanes.within = hn::Min(lanes.within, hn::SaturatedSub(this->probe.max[k], other_min));
    }
    return lanes;
  }
};

/// Of the 64 entries behind one of a leaf, in the mean of a few rows.
struct RowSample {
  float sure = 0;        ///< proved to overlap it
  float at_end = 0;      ///< begin at the step at which it ends, and may overlap it
  float all_at_end = 0;  ///< the same of all entries behind one, if the others are like those 64
};

template <int D>
HWY_INLINE RowSample sample_rows(ByteSweep<D>& sweep, std::uint32_t n) {
  Proved<D> proved(sweep);
  const std::uint32_t rows = std::min(n - 1, tuning::kDensityRows);
  int sure = 0;
  int at_end = 0;
  float all_at_end = 0;
  for (std::uint32_t k = 0; k < rows; ++k) {
    const auto i = static_cast<std::uint32_t>(sample_place(k, n - 1));
    const std::uint32_t sure_end = proved.sure_end(i);
    proved.seek(i);
    std::uint64_t unsure = 0;
    std::uint64_t maybe = 0;
    for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(Bytes())) {
      const ProvedLanes lanes = proved.lanes(i + 1 + lane);
      unsure |= bits_of_zeros(lanes.within) << lane;
      maybe |= bits_of_zeros(lanes.beyond) << lane;
    }
    const std::uint64_t before_end = first_bits(sure_end > i ? sure_end - i - 1 : 0);
    sure += std::popcount(~unsure & before_end);
    const std::uint32_t behind = proved.end(i) - i - 1;
    const int found_at_end = std::popcount(maybe & ~before_end & first_bits(behind));
    at_end += found_at_end;
    all_at_end += static_cast<float>(found_at_end) * std::max(1.0F, static_cast<float>(behind) / 64);
  }
  const auto count = static_cast<float>(rows);
  return {static_cast<float>(sure) / count, static_cast<float>(at_end) / count, all_at_end / count};
}

/// What bytes show of a row of entries that begin before another one ends.
struct RowBits {
  std::uint64_t maybe = 0;  ///< they may overlap
  std::uint64_t sure = 0;   ///< they are pairs
  std::uint64_t here = 0;   ///< their masks exclude nothing, as far as the bytes show
};

/// A dense leaf in its order.
template <int D>
struct Dense : Proved<D> {
  const std::uint8_t* others_apart;
  hn::Vec<Bytes> apart;

  HWY_INLINE explicit Dense(ByteSweep<D>& sweep)
      : Proved<D>(sweep), others_apart(sweep.apart.data()), apart(hn::Zero(Bytes())) {}

  HWY_INLINE void seek(std::uint32_t i) {
    Proved<D>::seek(i);
    apart = hn::Set(Bytes(), others_apart[i]);
  }
  template <std::uint32_t Row>
  [[nodiscard]] HWY_INLINE RowBits row(std::uint32_t j) const {
    const Bytes bytes;
    RowBits row;
    std::uint64_t unsure = 0;
    for (std::size_t lane = 0; lane < Row; lane += hn::Lanes(bytes)) {
      const ProvedLanes lanes = this->lanes(j + lane);
      row.maybe |= bits_of_zeros(lanes.beyond) << lane;
      unsure |= bits_of_zeros(lanes.within) << lane;
      row.here |= bits_of_zeros(hn::And(apart, hn::LoadU(bytes, others_apart + j + lane))) << lane;
    }
    row.sure = row.here & ~unsure;
    return row;
  }
};

/// Compares as `compare_all` does, and writes at once the pairs that need no confirmation. The other pairs
/// follow behind all of those, so that the order does not depend on the time of their confirmation.
template <std::uint32_t Row, int D>
HWY_INLINE void compare_dense(const LeafView<D>& leaf, ByteSweep<D>& sweep, PairBuffer& pairs) {
  const auto n = static_cast<std::uint32_t>(leaf.size());
  const std::uint64_t unknown = copy_in_order(leaf, sweep) ? 0 : UINT64_MAX;
  Dense<D> dense(sweep);
  const std::uint32_t* const objects = sweep.objects.data();
  const std::uint32_t* const order = sweep.order.data();
  std::uint32_t* const list = sweep.others.data();
  sweep.unsure.clear();
  Found found(sweep.found);
  for (std::uint32_t i = 0; i + 1 < n; ++i) {
    dense.seek(i);
    const std::uint32_t sure_end = dense.sure_end(i);
    const std::uint32_t end = dense.end(i);
    Pair* const begin = pairs.reserve(end - i + kRowRoom);
    RowWriter rows(objects[i], begin, list);
    for (std::uint32_t j = i + 1; j < end; j += Row) {
      const RowBits row = dense.template row<Row>(j);
      const std::uint64_t sure = row.sure & first_bits<Row>(sure_end > j ? sure_end - j : 0);
      const std::uint64_t others = row.maybe & ~sure & (row.here | unknown) & first_bits<Row>(end - j);
      rows.template add<Row>(objects + j, sure, end - j);
      found.add(others, order[i], j);
      if (!found.is_full()) continue;
      confirm_in<D>(leaf, order, found, sweep.unsure);
      found.clear();
    }
    pairs.commit(static_cast<std::size_t>(rows.finish() - begin));
  }
  confirm_in<D>(leaf, order, found, sweep.unsure);
  pairs.append(std::as_const(sweep.unsure).all());
}

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
