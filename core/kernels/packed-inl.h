// Packed boxes in vectors, for each of the machine's kinds of vectors: included once for each by the kernels
// (Highway's foreach_target), so there is no `#pragma once`.
#if defined(KERF_PACKED_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KERF_PACKED_INL_H
#undef KERF_PACKED_INL_H
#else
#define KERF_PACKED_INL_H
#endif

#include <hwy/highway.h>

#include <cfloat>
#include <cstddef>
#include <cstdint>

#include "core/geometry/packed_box.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Four floats on every machine: sums, and with them every choice, are the same everywhere.
using Four = hn::FixedTag<float, 4>;
using Floats = hn::Vec<Four>;

/// All lanes of a packed box, or of several side by side: in one vector if the machine has them as long, else
/// in more.
template <int D, int Boxes = 1>
struct Packed {
  static constexpr std::size_t kAll = std::size_t{2} * PackedBox<D>::kHalf * Boxes;
#if HWY_TARGET <= HWY_AVX2 && HWY_ARCH_X86
  static constexpr std::size_t kLanes = kAll;
#else
  static constexpr std::size_t kLanes = 4;
#endif
  static constexpr std::size_t kParts = kAll / kLanes;
  using Lanes = hn::FixedTag<float, kLanes>;
  hn::Vec<Lanes> part[kParts];
};

/// From the first of the boxes on. One is aligned: without AVX only then its load is part of what uses it.
template <int Boxes = 1, int D>
HWY_INLINE Packed<D, Boxes> load(const PackedBox<D>& first) {
  const typename Packed<D, Boxes>::Lanes lanes;
  Packed<D, Boxes> packed;
  for (std::size_t k = 0; k < packed.kParts; ++k) {
    const float* const from = first.lane.data() + k * packed.kLanes;
    packed.part[k] = Boxes == 1 ? hn::Load(lanes, from) : hn::LoadU(lanes, from);
  }
  return packed;
}

/// The same value in all lanes.
template <int D, int Boxes = 1>
HWY_INLINE Packed<D, Boxes> all_lanes(float value) {
  Packed<D, Boxes> packed;
  for (auto& part : packed.part) part = hn::Set(typename Packed<D, Boxes>::Lanes(), value);
  return packed;
}

template <int D, int Boxes>
HWY_INLINE void store(const Packed<D, Boxes>& packed, PackedBox<D>& first) {
  for (std::size_t k = 0; k < packed.kParts; ++k)
    hn::StoreU(packed.part[k], typename Packed<D, Boxes>::Lanes(), first.lane.data() + k * packed.kLanes);
}

/// (max, -min) of (min, -max): the other ends, as large as this box's own ends may become.
template <int D, int Boxes>
HWY_INLINE Packed<D, Boxes> turned(const Packed<D, Boxes>& packed) {
  if constexpr (D == 2) {
    Packed<D, Boxes> result;
    for (std::size_t k = 0; k < packed.kParts; ++k) result.part[k] = hn::Neg(hn::Shuffle1032(packed.part[k]));
    return result;
  } else if constexpr (Packed<D>::kParts == 1) {
    const typename Packed<D>::Lanes lanes;
    return {{hn::Neg(hn::ConcatLowerUpper(lanes, packed.part[0], packed.part[0]))}};
  } else {
    return {{hn::Neg(packed.part[1]), hn::Neg(packed.part[0])}};
  }
}

// `beyond`: all ones in the lanes where a is not at most b, so where one of them is NaN, too. `nowhere`: no
// lane is all ones.

#if HWY_TARGET <= HWY_AVX2 && HWY_ARCH_X86
// With AVX-512 Highway compares into a register for masks, from where an answer takes four instructions more.
using EightFloats = hn::Vec<hn::FixedTag<float, 8>>;
HWY_INLINE Floats beyond(Floats a, Floats b) { return {_mm_cmp_ps(a.raw, b.raw, _CMP_NLE_UQ)}; }
HWY_INLINE EightFloats beyond(EightFloats a, EightFloats b) {
  return {_mm256_cmp_ps(a.raw, b.raw, _CMP_NLE_UQ)};
}
HWY_INLINE bool nowhere(Floats lanes) { return _mm_testz_ps(lanes.raw, lanes.raw) != 0; }
HWY_INLINE bool nowhere(EightFloats lanes) { return _mm256_testz_ps(lanes.raw, lanes.raw) != 0; }
#else
HWY_INLINE Floats beyond(Floats a, Floats b) { return hn::VecFromMask(Four(), hn::Not(hn::Le(a, b))); }
HWY_INLINE bool nowhere(Floats lanes) { return hn::AllFalse(Four(), hn::MaskFromVec(lanes)); }
#endif

/// Whether no lane of a exceeds that of b, so that the box a holds the box b; NaN exceeds. Compilers would
/// test lane by lane.
template <int D>
HWY_INLINE bool at_most(const Packed<D>& a, const Packed<D>& b) {
  auto exceeding = beyond(a.part[0], b.part[0]);
  for (std::size_t k = 1; k < Packed<D>::kParts; ++k)
    exceeding = hn::Or(exceeding, beyond(a.part[k], b.part[k]));
  return nowhere(exceeding);
}

/// The lanes in which the boxes are apart: none, if they overlap (closed).
template <int D>
HWY_INLINE Packed<D> apart(const PackedBox<D>& a, const PackedBox<D>& b) {
  const Packed<D> one = load(a);
  const Packed<D> other = turned<D>(load(b));
  Packed<D> lanes;
  for (std::size_t k = 0; k < Packed<D>::kParts; ++k) lanes.part[k] = beyond(one.part[k], other.part[k]);
  return lanes;
}

/// Closed overlap.
template <int D>
HWY_INLINE bool boxes_overlap(const PackedBox<D>& a, const PackedBox<D>& b) {
  return at_most<D>(load(a), turned<D>(load(b)));
}

/// Ordered and finite: false for NaN.
template <int D>
HWY_INLINE bool is_valid(const Packed<D>& packed) {
  return at_most<D>(packed, turned<D>(packed)) && at_most<D>(all_lanes<D>(-FLT_MAX), packed);
}

/// From a box as callers give it.
template <int Boxes = 1>
HWY_INLINE Packed<3, Boxes> pack(const Box<3>& box) {
  static_assert(Boxes == 1);
  const Four four;
  const auto three = hn::FirstN(four, 3);
  const float* const first = box.min.value.data();
  const auto min = hn::IfThenElseZero(three, hn::LoadU(four, first));
  const auto max = hn::Shuffle0321(hn::LoadU(four, first + 2));  // z of min goes last
  const auto minus_max = hn::IfThenElseZero(three, hn::Neg(max));
  if constexpr (Packed<3, Boxes>::kParts == 1) {
    return {{hn::Combine(typename Packed<3, Boxes>::Lanes(), minus_max, min)}};
  } else {
    return {{min, minus_max}};
  }
}

/// From the first of the boxes on, as callers give them.
template <int Boxes = 1>
HWY_INLINE Packed<2, Boxes> pack(const Box<2>& first) {
  const typename Packed<2, Boxes>::Lanes lanes;
  const hn::RebindToUnsigned<typename Packed<2, Boxes>::Lanes> words;
  const auto sign_of_max = hn::ShiftLeft<30>(hn::And(hn::Iota(words, 0), hn::Set(words, 2)));
  Packed<2, Boxes> packed;
  for (std::size_t k = 0; k < packed.kParts; ++k)
    packed.part[k] = hn::Xor(hn::LoadU(lanes, first.min.value.data() + k * packed.kLanes),
                             hn::BitCast(lanes, sign_of_max));
  return packed;
}

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
