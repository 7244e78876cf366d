// Chosen lanes first, for each of the machine's kinds of vectors: included once for each by the kernels
// (Highway's foreach_target), so there is no `#pragma once`.
#ifndef KERF_COMPRESS_TABLES
#define KERF_COMPRESS_TABLES
#include <cstdint>

namespace kerf {

/// For each set of 8 lanes: the numbers of its lanes, then of the others, 4 bits each.
struct CompressTable {
  std::uint32_t order[256];
};
constexpr CompressTable make_compress_table() {
  CompressTable table{};
  for (std::uint32_t set = 0; set < 256; ++set) {
    unsigned place = 0;
    for (const bool chosen : {true, false})
      for (std::uint32_t lane = 0; lane < 8; ++lane)
        if (((set >> lane & 1U) != 0) == chosen) table.order[set] |= lane << 4 * place++;
  }
  return table;
}
inline constexpr CompressTable kCompressTable = make_compress_table();

/// The same for each set of 4 lanes of twice the width, as numbers of single ones.
constexpr CompressTable make_wide_compress_table() {
  CompressTable table{};
  for (std::uint32_t set = 0; set < 16; ++set) {
    std::uint32_t singles = 0;
    for (std::uint32_t lane = 0; lane < 4; ++lane)
      if ((set >> lane & 1U) != 0) singles |= 3U << 2 * lane;
    table.order[set] = kCompressTable.order[singles];
  }
  return table;
}
inline constexpr CompressTable kWideCompressTable = make_wide_compress_table();

}  // namespace kerf
#endif

#if defined(KERF_COMPRESS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KERF_COMPRESS_INL_H
#undef KERF_COMPRESS_INL_H
#else
#define KERF_COMPRESS_INL_H
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Words = hn::ScalableTag<std::uint32_t>;
using Doubles = hn::ScalableTag<std::uint64_t>;

#if HWY_TARGET == HWY_AVX2
// Not Highway's Compress: version 1.0.3 with GCC copies its table onto the stack for each vector.

/// The lanes whose numbers are in `order`, 4 bits each.
HWY_INLINE hn::Vec<Words> lanes_in_order(hn::Vec<Words> lanes, std::uint32_t order) {
  const Words words;
  const auto numbers = hn::Shr(hn::Set(words, order), hn::ShiftLeft<2>(hn::Iota(words, 0)));
  return hn::TableLookupLanes(lanes, hn::Indices256<std::uint32_t>{numbers.raw});
}

/// The chosen lanes in order, then anything.
HWY_INLINE hn::Vec<Words> compress_words(hn::Vec<Words> lanes, hn::Mask<Words> chosen) {
  return lanes_in_order(lanes, kCompressTable.order[hn::detail::BitsFromMask(chosen)]);
}
/// The same for lanes of twice the width.
HWY_INLINE hn::Vec<Doubles> compress_doubles(hn::Vec<Doubles> lanes, hn::Mask<Doubles> chosen) {
  const std::uint32_t order = kWideCompressTable.order[hn::detail::BitsFromMask(chosen)];
  return hn::BitCast(Doubles(), lanes_in_order(hn::BitCast(Words(), lanes), order));
}
#elif HWY_TARGET <= HWY_AVX3
// As above, for lanes of 64 bits. What follows the chosen lanes is left as it was, not made zero: for zeros
// some processors (Zen 4 and 5) wait for what the register held before.
HWY_INLINE hn::Vec<Words> compress_words(hn::Vec<Words> lanes, hn::Mask<Words> chosen) {
  return {_mm512_mask_compress_epi32(lanes.raw, chosen.raw, lanes.raw)};
}
HWY_INLINE hn::Vec<Doubles> compress_doubles(hn::Vec<Doubles> lanes, hn::Mask<Doubles> chosen) {
  return {_mm512_mask_compress_epi64(lanes.raw, chosen.raw, lanes.raw)};
}
#else
HWY_INLINE hn::Vec<Words> compress_words(hn::Vec<Words> lanes, hn::Mask<Words> chosen) {
  return hn::Compress(lanes, chosen);
}
HWY_INLINE hn::Vec<Doubles> compress_doubles(hn::Vec<Doubles> lanes, hn::Mask<Doubles> chosen) {
  return hn::Compress(lanes, chosen);
}
#endif

#if HWY_TARGET <= HWY_AVX3_DL && HWY_ARCH_X86
/// The positions of the bits, ascending, as bytes, then anything.
HWY_INLINE __m512i positions_of(std::uint64_t bits) {
  const __m512i all = hn::Iota(hn::ScalableTag<std::uint8_t>(), 0).raw;
  return _mm512_mask_compress_epi8(all, bits, all);
}
#endif

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
