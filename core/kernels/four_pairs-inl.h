// Four pairs at a time, where vectors have room for them (AVX2 and more): included once for each by the
// kernels (Highway's foreach_target), so there is no `#pragma once`.
#ifndef KERF_PAIR_ORDERS
#define KERF_PAIR_ORDERS
#include <array>
#include <cstddef>
#include <cstdint>

namespace kerf {

/// For each set of four pairs: the words of those in the set, then of the others.
struct PairOrder {
  std::uint32_t word[8];
};
constexpr std::array<PairOrder, 16> make_pair_orders() {
  std::array<PairOrder, 16> orders{};
  for (std::uint32_t set = 0; set < 16; ++set) {
    std::size_t place = 0;
    for (const bool chosen : {true, false})
      for (std::uint32_t pair = 0; pair < 4; ++pair) {
        if (((set >> pair & 1U) != 0) != chosen) continue;
        orders[set].word[place++] = 2 * pair;
        orders[set].word[place++] = 2 * pair + 1;
      }
  }
  return orders;
}
alignas(32) inline constexpr std::array<PairOrder, 16> kPairOrders = make_pair_orders();

}  // namespace kerf
#endif

#if defined(KERF_FOUR_PAIRS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KERF_FOUR_PAIRS_INL_H
#undef KERF_FOUR_PAIRS_INL_H
#else
#define KERF_FOUR_PAIRS_INL_H
#endif

#include <bit>

#include "core/base/ids.h"
#include "core/kernels/packed-inl.h"

#undef KERF_HAS_FOUR_PAIRS
#define KERF_HAS_FOUR_PAIRS (HWY_TARGET <= HWY_AVX2 && HWY_ARCH_X86_64)

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Pairs of words, each with the lower id first: nothing predicts which id is less.
template <class Words>
HWY_INLINE Words in_canonical_order(Words pairs) {
  const auto turned = hn::Shuffle2301(pairs);
  return hn::OddEven(hn::Max(pairs, turned), hn::Min(pairs, turned));
}

#if KERF_HAS_FOUR_PAIRS
using PairWords = hn::FixedTag<std::uint32_t, 8>;
using FourPairs = hn::Vec<PairWords>;

HWY_INLINE FourPairs load_pairs(const Pair* pairs) {
  static_assert(sizeof(Pair) == 2 * sizeof(std::uint32_t));
  return hn::LoadU(PairWords(), reinterpret_cast<const std::uint32_t*>(pairs));
}

using OnePair = hn::Vec<hn::FixedTag<std::uint32_t, 4>>;  ///< in the first two words

HWY_INLINE OnePair one_pair(std::uint32_t a, std::uint32_t b) {
  return {_mm_insert_epi32(_mm_cvtsi32_si128(static_cast<int>(a)), static_cast<int>(b), 1)};
}
HWY_INLINE FourPairs four_pairs(const OnePair (&pairs)[4]) {
  const auto two = [&](std::size_t k) HWY_ATTR { return _mm_unpacklo_epi64(pairs[k].raw, pairs[k + 1].raw); };
  return {_mm256_set_m128i(two(2), two(0))};
}

/// Writes the pairs whose bits are set, contiguously, and up to four undefined ones behind. Returns their
/// number.
HWY_INLINE std::size_t write_chosen(FourPairs pairs, unsigned chosen, Pair* out) {
  const auto order = hn::Load(PairWords(), kPairOrders[chosen].word);
  hn::StoreU(hn::TableLookupLanes(pairs, hn::Indices256<std::uint32_t>{order.raw}), PairWords(),
             reinterpret_cast<std::uint32_t*>(out));
  return static_cast<std::size_t>(std::popcount(chosen));
}

/// Makes some lane other than zero unless `bits` is.
template <int D>
HWY_INLINE void mark(std::uint64_t bits, Packed<D>& lanes) {
  const __m128i words = _mm_cvtsi64_si128(static_cast<long long>(bits));
  if constexpr (D == 2) {
    lanes.part[0].raw = _mm_or_ps(lanes.part[0].raw, _mm_castsi128_ps(words));
  } else {
    lanes.part[0].raw = _mm256_or_ps(lanes.part[0].raw, _mm256_castsi256_ps(_mm256_zextsi128_si256(words)));
  }
}

/// Bit k: all lanes of the k-th are zero. Words shrink to bytes, and a word other than zero to a byte other
/// than zero: then a box of four lanes is one word.
template <int D>
HWY_INLINE unsigned nowhere_of_four(const Packed<D> (&lanes)[4]) {
  if constexpr (D == 2) {
    const auto words = [&](std::size_t k) HWY_ATTR { return _mm_castps_si128(lanes[k].part[0].raw); };
    const __m128i bytes =
        _mm_packs_epi16(_mm_packs_epi32(words(0), words(1)), _mm_packs_epi32(words(2), words(3)));
    return static_cast<unsigned>(
        _mm_movemask_ps(_mm_castsi128_ps(_mm_cmpeq_epi32(bytes, _mm_setzero_si128()))));
  } else {
    const auto words = [&](std::size_t k) HWY_ATTR { return _mm256_castps_si256(lanes[k].part[0].raw); };
    const __m256i bytes =
        _mm256_packs_epi16(_mm256_packs_epi32(words(0), words(1)), _mm256_packs_epi32(words(2), words(3)));
    const auto halves = static_cast<unsigned>(
        _mm256_movemask_ps(_mm256_castsi256_ps(_mm256_cmpeq_epi32(bytes, _mm256_setzero_si256()))));
    return halves & (halves >> 4U);
  }
}

#endif

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
