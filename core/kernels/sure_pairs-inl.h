// Writing the pairs of one object with others that need no confirmation, for each of the machine's kinds of
// vectors: included once for each by the kernels (Highway's foreach_target), so there is no `#pragma once`.
#if defined(KERF_SURE_PAIRS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KERF_SURE_PAIRS_INL_H
#undef KERF_SURE_PAIRS_INL_H
#else
#define KERF_SURE_PAIRS_INL_H
#endif

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "core/base/ids.h"
#include "core/kernels/compress-inl.h"
#include "core/kernels/findings-inl.h"
#include "core/kernels/write_pairs-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

/// Behind the last pair of an object, up to so many undefined ones may be written.
inline constexpr std::size_t kRowRoom = 64;

// `RowWriter` writes the canonical pairs of one object with others, row by row: `add` takes those of `Row`
// others whose bits are set, in their order; from `room` on none is. `finish` returns the end of the pairs.
// `write_row` does so for one row.

#undef KERF_LISTS_OTHERS
#define KERF_LISTS_OTHERS (HWY_TARGET == HWY_AVX2 && HWY_ARCH_X86_64)

#if HWY_TARGET <= HWY_AVX3_DL && HWY_ARCH_X86_64
/// Sixteen of 64 words, chosen by their numbers.
HWY_INLINE __m512i look_up(const __m512i (&words)[4], __m512i numbers) {
  const __mmask16 is_high = _mm512_test_epi32_mask(numbers, _mm512_set1_epi32(32));
  return _mm512_mask_blend_epi32(is_high, _mm512_permutex2var_epi32(words[0], numbers, words[1]),
                                 _mm512_permutex2var_epi32(words[2], numbers, words[3]));
}

HWY_INLINE Pair* write_row(std::uint32_t object, const std::uint32_t* others, std::uint64_t bits, Pair* out) {
  const Words w;
  const auto own = hn::Set(w, object);
  const auto count = static_cast<std::size_t>(std::popcount(bits));
  const __m512i numbers = positions_of(bits);
  __m512i ids[4];
  for (std::size_t k = 0; k < 4; ++k) ids[k] = hn::LoadU(w, others + 16 * k).raw;
  const auto write = [&](__m128i which, std::size_t place) HWY_ATTR {
    const hn::Vec<Words> other{look_up(ids, _mm512_cvtepu8_epi32(which))};
    const __m512i low = hn::Min(other, own).raw;
    const __m512i high = hn::Max(other, own).raw;
    const __m512i first = _mm512_setr_epi32(0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23);
    const __m512i second = _mm512_add_epi32(first, _mm512_set1_epi32(8));
    _mm512_storeu_si512(out + place, _mm512_permutex2var_epi32(low, first, high));
    _mm512_storeu_si512(out + place + 8, _mm512_permutex2var_epi32(low, second, high));
  };
  write(_mm512_castsi512_si128(numbers), 0);
  write(_mm512_extracti32x4_epi32(numbers, 1), 16);
  if (count > 32) {
    write(_mm512_extracti32x4_epi32(numbers, 2), 32);
    write(_mm512_extracti32x4_epi32(numbers, 3), 48);
  }
  return out + count;
}
#elif HWY_TARGET <= HWY_AVX3 && HWY_ARCH_X86_64
HWY_INLINE Pair* write_row(std::uint32_t object, const std::uint32_t* others, std::uint64_t bits, Pair* out) {
  const Words w;
  const auto own = hn::Set(w, object);
  const std::size_t lanes = hn::Lanes(w);
  for (std::size_t k = 0; k < 64; k += lanes, bits >>= lanes) {
    const auto reported = hn::LoadMaskBits(w, reinterpret_cast<const std::uint8_t*>(&bits));
    out = write_pairs(own, hn::LoadU(w, others + k), reported, out);
  }
  return out;
}
#elif !KERF_LISTS_OTHERS
HWY_INLINE Pair* write_row(std::uint32_t object, const std::uint32_t* others, std::uint64_t bits, Pair* out) {
  const auto count = static_cast<std::size_t>(std::popcount(bits));
  constexpr std::uint64_t kLast = std::uint64_t{1} << 63U;
  for (std::size_t k = 0; k < count; k += 8)  // a fixed stride: the end of the row is easier to predict
    for (std::size_t m = k; m < k + 8; ++m, bits &= bits - 1)
      out[m] = {{object}, {others[hwy::Num0BitsBelowLS1Bit_Nonzero64(bits | kLast)]}};
  order_ids(out, count);
  return out + count;
}
#endif

#if KERF_LISTS_OTHERS
/// The others of all rows are listed first: few in a row are set, so the list has far fewer vectors than the
/// rows, and each makes eight pairs. In short rows nearly all that begin before the object ends are set, so
/// vectors list them.
class RowWriter {
 public:
  HWY_INLINE RowWriter(std::uint32_t object, Pair* out, std::uint32_t* list)
      : object_(object), out_(out), list_(list), next_(list) {}
  template <std::uint32_t Row>
  HWY_INLINE void add(const std::uint32_t* others, std::uint64_t bits, std::uint32_t room) {
    const auto count = static_cast<std::size_t>(std::popcount(bits));
    if constexpr (Row < 64) {
      list_many(others, bits, std::min(room, Row));
    } else if (HWY_UNLIKELY(count > kFewInRow)) {
      list_many(others, bits, Row);
    } else {  // in a fixed stride: the end of the row is easier to predict. Without a bit it reads the 65th
      for (std::size_t k = 0; k < count; k += 8)
        for (std::size_t m = k; m < k + 8; ++m, bits &= bits - 1) next_[m] = others[_tzcnt_u64(bits)];
    }
    next_ += count;
  }
  [[nodiscard]] HWY_INLINE Pair* finish() const {
    const Words w;
    const auto own = hn::Set(w, object_);
    const auto count = static_cast<std::size_t>(next_ - list_);
    for (std::size_t k = 0; k < count; k += 8) {
      const auto other = hn::LoadU(w, list_ + k);
      hn::StoreInterleaved2(hn::Min(other, own), hn::Max(other, own), w,
                            reinterpret_cast<std::uint32_t*>(out_ + k));
    }
    return out_ + count;
  }

 private:
  static constexpr std::size_t kFewInRow = 16;

  HWY_INLINE void list_many(const std::uint32_t* others, std::uint64_t bits, std::uint32_t room) {
    const Words w;
    std::uint32_t* out = next_;
    for (std::size_t k = 0; k < room; k += 8, bits >>= 8U) {
      const auto chosen = static_cast<std::uint8_t>(bits);
      hn::StoreU(lanes_in_order(hn::LoadU(w, others + k), kCompressTable.order[chosen]), w, out);
      out += std::popcount(chosen);
    }
  }

  std::uint32_t object_;
  Pair* out_;
  std::uint32_t* list_;
  std::uint32_t* next_;
};
#else
class RowWriter {
 public:
  HWY_INLINE RowWriter(std::uint32_t object, Pair* out, std::uint32_t* /*list*/)
      : object_(object), out_(out) {}
  template <std::uint32_t Row>
  HWY_INLINE void add(const std::uint32_t* others, std::uint64_t bits, std::uint32_t /*room*/) {
    out_ = write_row(object_, others, bits, out_);
  }
  [[nodiscard]] HWY_INLINE Pair* finish() const { return out_; }

 private:
  std::uint32_t object_;
  Pair* out_;
};
#endif

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
