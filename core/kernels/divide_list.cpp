#include "core/kernels/divide_list.h"

#include <algorithm>

#include "core/geometry/packed_box.h"
#include "core/kernels/prefetch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/divide_list.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/kernels/compress-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

using Signed = hn::ScalableTag<std::int32_t>;

/// What a vector of objects straddles: the masks of the lower lanes, and of the upper ones.
struct Straddle {
  hn::Vec<Doubles> low;
  hn::Vec<Doubles> high;
};

/// Of lanes that are all ones or nothing, the same of twice the width.
HWY_INLINE Straddle widen(hn::Vec<Signed> chosen) {
  const hn::Half<Signed> half;
  const hn::RebindToSigned<Doubles> wide;
  const Doubles doubles;
  return {hn::BitCast(doubles, hn::PromoteTo(wide, hn::LowerHalf(half, chosen))),
          hn::BitCast(doubles, hn::PromoteTo(wide, hn::UpperHalf(half, chosen)))};
}

/// Writes the chosen objects and their masks; returns their number. Whole vectors are written.
HWY_INLINE std::size_t write_chosen(hn::Vec<Words> objects, const Straddle& straddle, hn::Mask<Signed> chosen,
                                    std::uint32_t* to, DepthMask* to_straddle) {
  const Words words;
  const Signed ints;
  const Doubles doubles;
  const Straddle wide = widen(hn::VecFromMask(ints, chosen));
  const auto low = hn::MaskFromVec(wide.low);
  const auto high = hn::MaskFromVec(wide.high);
  hn::StoreU(compress_words(objects, hn::RebindMask(words, chosen)), words, to);
  const std::size_t in_low = hn::CountTrue(doubles, low);
  hn::StoreU(compress_doubles(straddle.low, low), doubles, to_straddle);
  hn::StoreU(compress_doubles(straddle.high, high), doubles, to_straddle + in_low);
  return in_low + hn::CountTrue(doubles, high);
}

/// Prefetches the boxes that will be read two vectors later.
template <int D>
HWY_INLINE void ask_ahead(const DivideJob& job, std::size_t k) {
  const std::size_t lanes = hn::Lanes(Words());
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const std::uint32_t object = job.objects[std::min(k + 2 * lanes + lane, job.end - 1)];
    prefetch(job.lo + std::size_t{object} * PackedBox<D>().lane.size());
  }
}

/// Values are read before their place can be written: the left part never overtakes the list.
template <int D>
HWY_INLINE Divided divide(const DivideJob& job) {
  const Words words;
  const Signed ints;
  const Doubles doubles;
  const hn::ScalableTag<Scalar> floats;
  constexpr int kShift = D == 2 ? 2 : 3;  // floats in a packed box
  const std::size_t lanes = hn::Lanes(words);
  const auto offset = hn::Set(floats, job.offset);
  const auto bit = hn::Set(doubles, job.bit);
  Divided at{job.begin, job.begin, job.end};
  for (; at.done + lanes <= job.end; at.done += lanes) {
    if (job.far) ask_ahead<D>(job, at.done);
    const auto objects = hn::LoadU(words, job.objects + at.done);
    Straddle straddle{hn::LoadU(doubles, job.straddle + at.done),
                      hn::LoadU(doubles, job.straddle + at.done + lanes / 2)};
    const auto place = hn::BitCast(ints, hn::ShiftLeft<kShift>(objects));
    const auto lo = hn::GatherIndex(floats, job.lo, place);
    const auto minus_hi = hn::GatherIndex(floats, job.minus_hi, place);
    const auto left = hn::RebindMask(ints, hn::Le(lo, offset));
    const auto right = hn::RebindMask(ints, hn::Lt(minus_hi, hn::Neg(offset)));
    const Straddle both = widen(hn::VecFromMask(ints, hn::And(left, right)));
    straddle.low = hn::Or(straddle.low, hn::And(both.low, bit));
    straddle.high = hn::Or(straddle.high, hn::And(both.high, bit));
    at.left += write_chosen(objects, straddle, left, job.objects + at.left, job.straddle + at.left);
    at.right += write_chosen(objects, straddle, right, job.objects + at.right, job.straddle + at.right);
  }
  return at;
}

Divided divide_2(const DivideJob& job) { return divide<2>(job); }
Divided divide_3(const DivideJob& job) { return divide<3>(job); }

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kerf {

HWY_EXPORT(divide_2);
HWY_EXPORT(divide_3);

template <>
Divided divide_list<2>(const DivideJob& job) {
  static_assert(sizeof(PackedBox<2>) == sizeof(Scalar) << 2U);
  return HWY_DYNAMIC_DISPATCH(divide_2)(job);
}
template <>
Divided divide_list<3>(const DivideJob& job) {
  static_assert(sizeof(PackedBox<3>) == sizeof(Scalar) << 3U);
  return HWY_DYNAMIC_DISPATCH(divide_3)(job);
}

}  // namespace kerf
#endif
