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

#include "core/broad_phase/pair_buffer.h"
#include "core/kernels/bytes-inl.h"
#include "core/kernels/found_at.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

/// The pair in canonical order, in a way of which no compiler makes a branch: nothing predicts whose id is
/// less.
HWY_INLINE Pair ordered_pair(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t swapped = (a ^ b) & (0U - static_cast<std::uint32_t>(a > b));
  return {ObjectId{a ^ swapped}, ObjectId{b ^ swapped}};
}

/// One of two entries that may be a pair.
template <int D>
struct EntryRef {
  const PackedBox<D>& box;
  std::uint32_t object;
  DepthMask apart;
};

/// Confirms on the floats what the bytes have found; `first` and `second` give the entry at a place. No
/// branch depends on the outcome.
template <int D, class First, class Second>
HWY_INLINE void confirm(const FoundAt* found, std::size_t count, First first, Second second,
                        PairBuffer& pairs) {
  Pair* const HWY_RESTRICT out = pairs.reserve(count);
  std::size_t written = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const EntryRef<D> a = first(found[k].i);
    const EntryRef<D> b = second(found[k].j);
    const bool overlap = ends_overlap<D>(load_ends(a.box), load_ends(b.box));
    const bool here = (a.apart & b.apart) == 0;
    out[written] = ordered_pair(a.object, b.object);
    written += static_cast<std::size_t>(overlap & here);
  }
  pairs.commit(written);
}

/// As many of the lowest bits, or all.
HWY_INLINE std::uint64_t first_bits(std::uint32_t count) {
  return count < 64 ? (std::uint64_t{1} << count) - 1 : UINT64_MAX;
}

/// The number of the lowest bit; anything if there is none. To the compiler there is always one, or it would
/// make a branch for the other case, which nothing predicts.
HWY_INLINE std::uint64_t lowest_bit(std::uint64_t bits) {
  return static_cast<std::uint64_t>(std::countr_zero(bits | (std::uint64_t{1} << 63U)));
}

/// Writes (i, j + k) for each bit k and gives their number. Four are written whether they are there or not:
/// few rows have more, and the branch that tells is seldom mispredicted.
HWY_INLINE std::size_t list_bits(std::uint64_t bits, std::uint32_t i, std::uint32_t j, FoundAt* found) {
  const auto count = static_cast<std::size_t>(std::popcount(bits));
  const std::uint64_t first = i | std::uint64_t{j} << 32U;
  const auto write = [&](std::size_t k) {
    const std::uint64_t both = first + (lowest_bit(bits) << 32U);
    found[k] = {static_cast<std::uint32_t>(both), static_cast<std::uint32_t>(both >> 32U)};
    bits &= bits - 1;
  };
  for (std::size_t k = 0; k < 4; ++k) write(k);
  for (std::size_t k = 4; k < count; ++k) write(k);
  return count;
}

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
