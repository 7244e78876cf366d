// What vectors of bytes have found, and its confirmation on floats, for each of the machine's kinds of
// vectors: included once for each by the kernels (Highway's foreach_target), so there is no `#pragma once`.
#if defined(KERF_FINDINGS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KERF_FINDINGS_INL_H
#undef KERF_FINDINGS_INL_H
#else
#define KERF_FINDINGS_INL_H
#endif

#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/base/append_buffer.h"
#include "core/kernels/bytes-inl.h"
#include "core/kernels/compress-inl.h"
#include "core/kernels/found_rows.h"
#include "core/kernels/four_pairs-inl.h"
#include "core/kernels/packed-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

/// Puts pairs in canonical order, a vector of them at a time.
HWY_INLINE void order_ids(Pair* pairs, std::size_t count) {
  static_assert(sizeof(Pair) == 2 * sizeof(std::uint32_t));
  const hn::ScalableTag<std::uint32_t> lanes;
  const std::size_t step = hn::Lanes(lanes) / 2;
  std::size_t k = 0;
  for (; k + step <= count; k += step) {
    auto* const at = reinterpret_cast<std::uint32_t*>(pairs + k);
    hn::StoreU(in_canonical_order(hn::LoadU(lanes, at)), lanes, at);
  }
  for (; k < count; ++k) pairs[k] = make_pair(pairs[k].a, pairs[k].b);
}

/// One of two entries that may be a pair.
template <int D>
struct EntryRef {
  const PackedBox<D>& box;
  std::uint32_t object;
  DepthMask apart;
};

#undef KERF_HAS_LISTED_ROWS
#define KERF_HAS_LISTED_ROWS (HWY_TARGET <= HWY_AVX3_DL && HWY_ARCH_X86_64)

#if KERF_HAS_LISTED_ROWS
/// Findings not confirmed yet, each row spread over a list at once: vectors that compress bytes give the
/// positions of its bits.
class Found {
 public:
  HWY_INLINE explicit Found(Findings& room) : first_(room.first.data()), second_(room.second.data()) {}

  HWY_INLINE void add(std::uint64_t bits, std::uint32_t i, std::uint32_t j) {
    const auto count = static_cast<std::size_t>(std::popcount(bits));
    const __m512i at = positions_of(bits);
    write(_mm512_castsi512_si128(at), i, j, count_);
    if (count > 16) {
      write(_mm512_extracti32x4_epi32(at, 1), i, j, count_ + 16);
      write(_mm512_extracti32x4_epi32(at, 2), i, j, count_ + 32);
      write(_mm512_extracti32x4_epi32(at, 3), i, j, count_ + 48);
    }
    count_ += count;
  }
  [[nodiscard]] HWY_INLINE bool is_full() const { return count_ >= kConfirmListed; }
  [[nodiscard]] HWY_INLINE std::size_t count() const { return count_; }
  HWY_INLINE void clear() { count_ = 0; }

  /// Visits all findings.
  class Walk {
   public:
    HWY_INLINE explicit Walk(const Found& found) : first_(found.first_), second_(found.second_) {}
    [[nodiscard]] HWY_INLINE std::uint32_t i() const { return first_[k_]; }
    [[nodiscard]] HWY_INLINE std::uint32_t j() const { return second_[k_]; }
    HWY_INLINE void advance() { ++k_; }

   private:
    const std::uint32_t* first_;
    const std::uint32_t* second_;
    std::size_t k_ = 0;
  };

 private:
  HWY_INLINE void write(__m128i at, std::uint32_t i, std::uint32_t j, std::size_t place) {
    const hn::Full512<std::uint32_t> words;
    hn::StoreU(hn::Set(words, i), words, first_ + place);
    const hn::Vec<decltype(words)> distance{_mm512_cvtepu8_epi32(at)};
    hn::StoreU(hn::Add(hn::Set(words, j), distance), words, second_ + place);
  }

  std::uint32_t* const first_;
  std::uint32_t* const second_;
  std::size_t count_ = 0;
};
#else
/// Findings not confirmed yet: rows that have findings.
class Found {
 public:
  HWY_INLINE explicit Found(Findings& room) : first_(room.rows.data()), end_(first_) {}

  /// A row without a finding is overwritten by the next one.
  HWY_INLINE void add(std::uint64_t bits, std::uint32_t i, std::uint32_t j) {
    *end_ = {bits, i, j};
    end_ += bits != 0 ? 1 : 0;
    count_ += static_cast<std::size_t>(std::popcount(bits));
  }
  [[nodiscard]] HWY_INLINE bool is_full() const { return end_ == first_ + kConfirmRows; }
  [[nodiscard]] HWY_INLINE std::size_t count() const { return count_; }
  HWY_INLINE void clear() {
    end_ = first_;
    count_ = 0;
  }

  /// Visits all findings without a branch: nothing predicts how many a row has.
  class Walk {
   public:
    HWY_INLINE explicit Walk(const Found& found)
        : row_(found.first_), bits_(row_->bits), next_(row_[1].bits) {}

    [[nodiscard]] HWY_INLINE std::uint32_t i() const { return row_->i; }
    [[nodiscard]] HWY_INLINE std::uint32_t j() const {
      return row_->j + static_cast<std::uint32_t>(hwy::Num0BitsBelowLS1Bit_Nonzero64(bits_));
    }
    HWY_INLINE void advance() {
      bits_ &= bits_ - 1;
      const std::uint64_t all_if_done = 0 - static_cast<std::uint64_t>(bits_ == 0);
      bits_ |= next_ & all_if_done;
      row_ -= static_cast<std::ptrdiff_t>(all_if_done);
      next_ = row_[1].bits;
    }

   private:
    const FoundRow* row_;
    std::uint64_t bits_;
    std::uint64_t next_;  ///< of the next row: loaded before it is known whether it is needed
  };

 private:
  FoundRow* const first_;
  FoundRow* end_;
  std::size_t count_ = 0;
};
#endif

#if KERF_HAS_FOUR_PAIRS
/// Confirms the next four findings. Returns how many of them are pairs.
template <int D, class First, class Second>
HWY_INLINE std::size_t confirm_four(Found::Walk& walk, First first, Second second, Pair* out) {
  Packed<D> lanes[4];
  OnePair pairs[4];
  for (std::size_t k = 0; k < 4; ++k, walk.advance()) {
    const EntryRef<D> a = first(walk.i());
    const EntryRef<D> b = second(walk.j());
    pairs[k] = one_pair(a.object, b.object);
    lanes[k] = apart<D>(a.box, b.box);
    mark(a.apart & b.apart, lanes[k]);
  }
  return write_chosen(in_canonical_order(four_pairs(pairs)), nowhere_of_four<D>(lanes), out);
}
#endif

/// Confirms on the floats what the bytes have found, and empties the list; `first` and `second` return the
/// entry at a place. No branch depends on the outcome.
template <int D, class First, class Second>
HWY_INLINE void confirm(Found& found, First first, Second second, PairBuffer& pairs) {
  std::size_t left = found.count();
  Pair* const begin = pairs.reserve(left);
  Pair* HWY_RESTRICT out = begin;
  Found::Walk walk(found);
#if KERF_HAS_FOUR_PAIRS
  for (; left >= 4; left -= 4) out += confirm_four<D>(walk, first, second, out);
#endif
  Pair* const rest = out;
  for (; left > 0; --left, walk.advance()) {
    const EntryRef<D> a = first(walk.i());
    const EntryRef<D> b = second(walk.j());
    const bool overlap = boxes_overlap<D>(a.box, b.box);
    const bool here = (a.apart & b.apart) == 0;
    *out = {ObjectId{a.object}, ObjectId{b.object}};
    out += static_cast<std::ptrdiff_t>(overlap & here);
  }
  order_ids(rest, static_cast<std::size_t>(out - rest));
  pairs.commit(static_cast<std::size_t>(out - begin));
  found.clear();
}

/// The `count` lowest of the bits of a row, or all.
template <std::uint32_t Row = 64>
HWY_INLINE std::uint64_t first_bits(std::uint32_t count) {
  return count < Row ? (std::uint64_t{1} << count) - 1 : ~std::uint64_t{0} >> (64 - Row);
}

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
