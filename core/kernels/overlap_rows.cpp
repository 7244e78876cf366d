#include "core/kernels/overlap_rows.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/overlap_rows.cpp"
#include <hwy/foreach_target.h>

#include "core/kernels/block_tests-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

static_assert(BoxColumns::kStep % kPart == 0);

/// Not in arrays, as in OverlapTest.
template <int D>
struct ColumnsTest {
  HWY_INLINE ColumnsTest(const BoxColumns& boxes, std::size_t object)
      : stride(boxes.stride),
        min_0(column(boxes, object, 0)),
        min_1(column(boxes, object, 1)),
        min_2(column(boxes, object, D - 1)),
        max_0(column(boxes, object, D)),
        max_1(column(boxes, object, D + 1)),
        max_2(column(boxes, object, 2 * D - 1)) {}
  /// `at`: the minima of some boxes along the first axis.
  HWY_INLINE Marks operator()(const Scalar* at) const {
    const FloatTag f;
    const auto hit_0 = hn::And(hn::Le(min_0, hn::LoadU(f, at + D * stride)), hn::Le(hn::LoadU(f, at), max_0));
    const auto hit_1 =
        hn::And(hn::Le(min_1, hn::LoadU(f, at + (D + 1) * stride)), hn::Le(hn::LoadU(f, at + stride), max_1));
    const auto hit = hn::And(hit_0, hit_1);
    if constexpr (D == 2) return hit;
    const auto hit_2 = hn::And(hn::Le(min_2, hn::LoadU(f, at + (2 * D - 1) * stride)),
                               hn::Le(hn::LoadU(f, at + (D - 1) * stride), max_2));
    return hn::And(hit, hit_2);
  }
  static HWY_INLINE Some column(const BoxColumns& boxes, std::size_t object, std::size_t k) {
    return hn::Set(FloatTag(), boxes.numbers[k * boxes.stride + object]);
  }
  std::size_t stride;
  Some min_0, min_1, min_2;
  Some max_0, max_1, max_2;
};

template <int D>
HWY_INLINE void find_rows(const BoxColumns& boxes, const ObjectId* objects, std::size_t count,
                          std::uint64_t* rows) {
  constexpr std::size_t kBits = 64;
  for (std::size_t k = 0; k < count; ++k) {
    const ColumnsTest<D> test(boxes, objects[k].index());
    for (std::size_t begin = 0; begin < boxes.stride; begin += kBits) {
      const std::size_t some = HWY_MIN(boxes.stride - begin, kBits);
      std::uint64_t bits = 0;
      for (std::size_t i = 0; i < some; i += kPart)
        bits |= std::uint64_t{bits_of(test(boxes.numbers + begin + i))} << i;
      *rows++ = bits;
    }
  }
}

void find_rows_2(const BoxColumns& boxes, const ObjectId* objects, std::size_t count, std::uint64_t* rows) {
  find_rows<2>(boxes, objects, count, rows);
}
void find_rows_3(const BoxColumns& boxes, const ObjectId* objects, std::size_t count, std::uint64_t* rows) {
  find_rows<3>(boxes, objects, count, rows);
}

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kerf {

HWY_EXPORT(find_rows_2);
HWY_EXPORT(find_rows_3);

template <>
void overlap_rows<2>(const BoxColumns& boxes, const ObjectId* objects, std::size_t count,
                     std::uint64_t* rows) {
  HWY_DYNAMIC_DISPATCH(find_rows_2)(boxes, objects, count, rows);
}
template <>
void overlap_rows<3>(const BoxColumns& boxes, const ObjectId* objects, std::size_t count,
                     std::uint64_t* rows) {
  HWY_DYNAMIC_DISPATCH(find_rows_3)(boxes, objects, count, rows);
}

}  // namespace kerf
#endif
