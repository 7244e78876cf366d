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

#include "core/kernels/compress-inl.h"
#include "core/kernels/search_blocks.h"
#include "core/kernels/wide_block.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET <= HWY_AVX3 && HWY_ARCH_X86
constexpr std::size_t kPart = 16;
#elif HWY_TARGET <= HWY_AVX2 && HWY_ARCH_X86
constexpr std::size_t kPart = 8;
#else
constexpr std::size_t kPart = 4;
#endif

using FloatTag = hn::FixedTag<float, kPart>;
using WordTag = hn::FixedTag<std::uint32_t, kPart>;
using Some = hn::Vec<FloatTag>;
using Marks = hn::Mask<FloatTag>;

HWY_INLINE std::uint32_t bits_of(Marks marks) {
  std::uint64_t bits = 0;
  hn::StoreMaskBits(FloatTag(), marks, reinterpret_cast<std::uint8_t*>(&bits));
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
  const WordTag words;
  const auto items = hn::Load(words, block.item + k);
  const auto chosen = hn::RebindMask(words, marks);
  // Not by CompressStore, which takes some processors ten times as long.
  hn::StoreU(compress_words(items, chosen), words, out);
  return hn::CountTrue(words, chosen);
}

/// Not in arrays: the compiler would not keep them in registers.
template <int D>
struct OverlapTest {
  explicit OverlapTest(const Box<D>& box)
      : min_0(hn::Set(FloatTag(), box.min.value[0])),
        min_1(hn::Set(FloatTag(), box.min.value[1])),
        min_2(hn::Set(FloatTag(), box.min.value[D - 1])),
        max_0(hn::Set(FloatTag(), box.max.value[0])),
        max_1(hn::Set(FloatTag(), box.max.value[1])),
        max_2(hn::Set(FloatTag(), box.max.value[D - 1])) {}
  HWY_INLINE Marks operator()(const WideBlock<D>& block, std::size_t k) const {
    const FloatTag f;
    const auto hit_0 =
        hn::And(hn::Le(min_0, hn::Load(f, block.max[0] + k)), hn::Le(hn::Load(f, block.min[0] + k), max_0));
    const auto hit_1 =
        hn::And(hn::Le(min_1, hn::Load(f, block.max[1] + k)), hn::Le(hn::Load(f, block.min[1] + k), max_1));
    const auto hit = hn::And(hit_0, hit_1);
    if constexpr (D == 2) return hit;
    const auto hit_2 = hn::And(hn::Le(min_2, hn::Load(f, block.max[D - 1] + k)),
                               hn::Le(hn::Load(f, block.min[D - 1] + k), max_2));
    return hn::And(hit, hit_2);
  }
  Some min_0, min_1, min_2;
  Some max_0, max_1, max_2;
};

/// `key`: how near the box is at least. `sure_of` makes a mask of it.
struct Answer {
  Marks possible;
  Some key;
  Some end;  ///< of casts
};

template <int D, class Test>
struct TestOf;

template <int D>
struct TestOf<D, CastTest<D>> {
  HWY_INLINE explicit TestOf(const CastTest<D>& test) : given(test) {
    for (std::size_t i = 0; i < D; ++i) falls_[i] = test.direction[i] < 0 ? D : 0;
  }
  HWY_INLINE Answer operator()(const WideBlock<D>& block, std::size_t k) const {
    const FloatTag f;
    Some begin = hn::Zero(f);
    Some end = hn::Set(f, given.max_t);
    const float* const rows = block.min[0] + k;  // those of the maxima follow
    if (HWY_LIKELY(given.moves_on_all)) {
      for (std::size_t i = 0; i < D; ++i) meet(rows, i, begin, end);
      return {hn::Le(begin, end), begin, end};
    }
    Marks stays = hn::Eq(begin, begin);
    Marks stays_inside = stays;  // where denormals are zero, ends that seem to touch may lie apart
    for (std::size_t i = 0; i < D; ++i) {
      if (given.direction[i] != 0) {
        meet(rows, i, begin, end);
        continue;
      }
      const Some min = hn::Load(f, rows + i * kBlockWidth);
      const Some max = hn::Load(f, rows + (i + D) * kBlockWidth);
      const Some near = hn::Set(f, given.near_start[i]);
      const Some far = hn::Set(f, given.far_start[i]);
      stays = hn::And(stays, hn::And(hn::Le(min, near), hn::Ge(max, far)));
      stays_inside = hn::And(stays_inside, hn::And(hn::Lt(min, near), hn::Gt(max, far)));
    }
    return {hn::And(stays, hn::Le(begin, end)), begin, hn::IfThenElse(stays_inside, end, hn::Set(f, -1.0F))};
  }
  HWY_INLINE Marks sure_of(const Answer& answer) const {
    const FloatTag f;
    const Some latest = hn::Add(hn::Mul(answer.key, hn::Set(f, 1 + 0x1p-18F)), hn::Set(f, given.blur));
    return hn::Le(latest, hn::Mul(hn::Min(answer.end, hn::Set(f, FLT_MAX)), hn::Set(f, 1 - 0x1p-18F)));
  }

  const CastTest<D>& given;

 private:
  HWY_INLINE void meet(const float* rows, std::size_t i, Some& begin, Some& end) const {
    const FloatTag f;
    const Some near = hn::Load(f, rows + (i + falls_[i]) * kBlockWidth);
    const Some far = hn::Load(f, rows + (i + D - falls_[i]) * kBlockWidth);
    begin = hn::Max(
        begin, hn::Mul(hn::Sub(near, hn::Set(f, given.near_start[i])), hn::Set(f, given.near_factor[i])));
    end =
        hn::Min(end, hn::Mul(hn::Sub(far, hn::Set(f, given.far_start[i])), hn::Set(f, given.far_factor[i])));
  }
  std::size_t falls_[D];  ///< rows from the minimum of an axis to its near end
};

template <int D>
struct TestOf<D, BallTest<D>> {
  explicit TestOf(const BallTest<D>& test) : given(test) {}
  HWY_INLINE Answer operator()(const WideBlock<D>& block, std::size_t k) const {
    const FloatTag f;
    Some sum = hn::Zero(f);
    for (std::size_t i = 0; i < D; ++i) {
      const Some center = hn::Set(f, given.center[i]);
      const Some below = hn::Sub(hn::Load(f, block.min[i] + k), center);
      const Some above = hn::Sub(center, hn::Load(f, block.max[i] + k));
      const Some apart = hn::Max(hn::Max(below, above), hn::Zero(f));
      sum = hn::Add(sum, hn::Mul(apart, apart));
    }
    return {hn::Le(sum, hn::Set(f, given.possible)), sum, sum};
  }
  HWY_INLINE Marks sure_of(const Answer& answer) const {
    return hn::Le(answer.key, hn::Set(FloatTag(), given.sure));
  }
  const BallTest<D>& given;
};

template <int D>
struct TestOf<D, HalfSpacesTest<D>> {
  explicit TestOf(const HalfSpacesTest<D>& test) : given(test) {}
  HWY_INLINE Answer operator()(const WideBlock<D>& block, std::size_t k) const {
    const FloatTag f;
    const Marks placed = hn::Le(hn::Load(f, block.min[0] + k), hn::Load(f, block.max[0] + k));
    Marks possible = placed;
    Some excess = hn::Set(f, -FLT_MAX);
    for (const RoundedHalfSpace<D>& space : given.all) {
      Some sum = hn::Zero(f);
      Some size = hn::Zero(f);
      for (std::size_t i = 0; i < D; ++i) {
        if (space.normal[i] == 0) continue;
        const float* const corner = space.normal[i] > 0 ? block.min[i] : block.max[i];
        const Some end = hn::IfThenElseZero(placed, hn::Load(f, corner + k));  // no inf - inf, a signal
        const Some term = hn::Mul(end, hn::Set(f, space.normal[i]));
        sum = hn::Add(sum, term);
        size = hn::Add(size, hn::Abs(term));
      }
      const Some slack = hn::Add(hn::Mul(size, hn::Set(f, 0x1p-20F)), hn::Set(f, 0x1p-123F));
      possible = hn::And(possible, hn::Le(hn::Sub(sum, slack), hn::Set(f, space.possible)));
      excess = hn::Max(excess, hn::Sub(hn::Add(sum, slack), hn::Set(f, space.sure)));
    }
    return {possible, excess, excess};
  }
  HWY_INLINE Marks sure_of(const Answer& answer) const { return hn::Le(answer.key, hn::Zero(FloatTag())); }
  const HalfSpacesTest<D>& given;
};

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
