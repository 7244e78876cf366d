// Tests of the boxes of a block, for each of the machine's kinds of vectors: included once for each by the
// kernel (Highway's foreach_target), so there is no `#pragma once`.
#if defined(KERF_BLOCK_TESTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KERF_BLOCK_TESTS_INL_H
#undef KERF_BLOCK_TESTS_INL_H
#else
#define KERF_BLOCK_TESTS_INL_H
#endif

#include <hwy/highway.h>

#include <cfloat>
#include <cstddef>
#include <cstdint>

#include "core/kernels/search_blocks.h"
#include "core/kernels/wide_block.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t kWidth = 8;
#if HWY_TARGET <= HWY_AVX2 && HWY_ARCH_X86
constexpr std::size_t kPart = 8;
#else
constexpr std::size_t kPart = 4;
#endif

using Floats = hn::FixedTag<float, kPart>;
using Words = hn::FixedTag<std::uint32_t, kPart>;
using Some = hn::Vec<Floats>;
using Marks = hn::Mask<Floats>;

HWY_INLINE std::uint32_t bits_of(Marks marks) {
  std::uint64_t bits = 0;
  hn::StoreMaskBits(Floats(), marks, reinterpret_cast<std::uint8_t*>(&bits));
  return static_cast<std::uint32_t>(bits) & ((1U << kPart) - 1U);
}

HWY_INLINE std::uint32_t first_bit(std::uint32_t bits) {
  return static_cast<std::uint32_t>(__builtin_ctz(bits));
}

/// Writes the items of the marked lanes, and something behind them: there must be room for a vector. Returns
/// the number of marked ones.
template <int D>
HWY_INLINE std::size_t write_items(const WideBlock<D>& block, std::size_t k, Marks marks,
                                   std::uint32_t* out) {
  const Words words;
  const auto items = hn::Load(words, block.item + k);
  return hn::CompressStore(items, hn::RebindMask(words, marks), words, out);
}

template <int D>
struct OverlapTest {
  explicit OverlapTest(const Box<D>& box) {
    for (int i = 0; i < D; ++i) {
      min[i] = hn::Set(Floats(), box.min.value[i]);
      max[i] = hn::Set(Floats(), box.max.value[i]);
    }
  }
  HWY_INLINE Marks operator()(const WideBlock<D>& block, std::size_t k) const {
    Marks hit = hn::Le(min[0], hn::Load(Floats(), block.max[0] + k));
    hit = hn::And(hit, hn::Le(hn::Load(Floats(), block.min[0] + k), max[0]));
    for (int i = 1; i < D; ++i) {
      hit = hn::And(hit, hn::Le(min[i], hn::Load(Floats(), block.max[i] + k)));
      hit = hn::And(hit, hn::Le(hn::Load(Floats(), block.min[i] + k), max[i]));
    }
    return hit;
  }
  Some min[D];
  Some max[D];
};

/// `key`: how near the box is at least.
struct Answer {
  Marks possible;
  Marks sure;
  Some key;
};

template <int D, class Test>
struct TestOf;

template <int D>
struct TestOf<D, CastTest<D>> {
  explicit TestOf(const CastTest<D>& test) : given(test) {}
  HWY_INLINE Answer operator()(const WideBlock<D>& block, std::size_t k) const {
    const Floats f;
    Some begin = hn::Zero(f);
    Some end = hn::Set(f, given.max_t);
    Marks stays = hn::Eq(begin, begin);
    for (std::size_t i = 0; i < D; ++i) {
      const Some up = hn::Sub(hn::Load(f, block.min[i] + k), hn::Set(f, given.high[i]));
      const Some down = hn::Sub(hn::Load(f, block.max[i] + k), hn::Set(f, given.low[i]));
      if (given.direction[i] == 0) {  // of a difference the sign is exact
        stays = hn::And(stays, hn::And(hn::Le(up, hn::Zero(f)), hn::Ge(down, hn::Zero(f))));
        continue;
      }
      const bool rises = given.direction[i] > 0;
      begin = hn::Max(begin, hn::Mul(rises ? up : down, hn::Set(f, given.begin_factor[i])));
      end = hn::Min(end, hn::Mul(rises ? down : up, hn::Set(f, given.end_factor[i])));
    }
    const Some latest = hn::Add(hn::Mul(begin, hn::Set(f, 1 + 0x1p-18F)), hn::Set(f, 0x1p-100F));
    const Some earliest = hn::Mul(hn::Min(end, hn::Set(f, FLT_MAX)), hn::Set(f, 1 - 0x1p-18F));
    return {hn::And(stays, hn::Le(begin, end)), hn::Le(latest, earliest), begin};
  }
  const CastTest<D>& given;
};

template <int D>
struct TestOf<D, BallTest<D>> {
  explicit TestOf(const BallTest<D>& test) : given(test) {}
  HWY_INLINE Answer operator()(const WideBlock<D>& block, std::size_t k) const {
    const Floats f;
    Some sum = hn::Zero(f);
    for (std::size_t i = 0; i < D; ++i) {
      const Some center = hn::Set(f, given.center[i]);
      const Some below = hn::Sub(hn::Load(f, block.min[i] + k), center);
      const Some above = hn::Sub(center, hn::Load(f, block.max[i] + k));
      const Some apart = hn::Max(hn::Max(below, above), hn::Zero(f));
      sum = hn::Add(sum, hn::Mul(apart, apart));
    }
    return {hn::Le(sum, hn::Set(f, given.possible)), hn::Le(sum, hn::Set(f, given.sure)), sum};
  }
  const BallTest<D>& given;
};

template <int D>
struct TestOf<D, HalfSpacesTest<D>> {
  explicit TestOf(const HalfSpacesTest<D>& test) : given(test) {}
  HWY_INLINE Answer operator()(const WideBlock<D>& block, std::size_t k) const {
    const Floats f;
    Marks possible = hn::Le(hn::Load(f, block.min[0] + k), hn::Load(f, block.max[0] + k));
    Marks sure = possible;
    for (const HalfSpace<D>& space : given.all) {
      Some sum = hn::Zero(f);
      Some size = hn::Zero(f);
      for (std::size_t i = 0; i < D; ++i) {
        if (space.normal[i] == 0) continue;
        const float* const corner = space.normal[i] > 0 ? block.min[i] : block.max[i];
        const Some term = hn::Mul(hn::Load(f, corner + k), hn::Set(f, space.normal[i]));
        sum = hn::Add(sum, term);
        size = hn::Add(size, hn::Abs(term));
      }
      const Some slack = hn::Add(hn::Mul(size, hn::Set(f, 0x1p-20F)), hn::Set(f, FLT_MIN));
      possible = hn::And(possible, hn::Le(hn::Sub(sum, slack), hn::Set(f, space.possible)));
      sure = hn::And(sure, hn::Le(hn::Add(sum, slack), hn::Set(f, space.sure)));
    }
    return {possible, sure, hn::Zero(f)};
  }
  const HalfSpacesTest<D>& given;
};

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
