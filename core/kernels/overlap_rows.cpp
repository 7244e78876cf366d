#include "core/kernels/overlap_rows.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/overlap_rows.cpp"
#include <hwy/foreach_target.h>

#include "core/kernels/block_tests-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

template <int D>
HWY_INLINE void find_rows(std::span<const WideBlock<D>> boxes, std::span<const ObjectId> objects,
                          std::uint64_t* rows) {
  constexpr std::size_t kBlocks = 64 / kBlockWidth;  // of a word
  for (const ObjectId object : objects) {
    const OverlapTest<D> test(boxes[object.index() / kBlockWidth].box(object.index() % kBlockWidth));
    for (std::size_t begin = 0; begin < boxes.size(); begin += kBlocks) {
      const std::size_t end = std::min(begin + kBlocks, boxes.size());
      std::uint64_t bits = 0;
      std::size_t place = 0;
      for (std::size_t block = begin; block < end; ++block)
        for (std::size_t k = 0; k < kBlockWidth; k += kPart, place += kPart)
          bits |= std::uint64_t{bits_of(test(boxes[block], k))} << place;
      *rows++ = bits;
    }
  }
}

void find_rows_2(std::span<const WideBlock<2>> boxes, std::span<const ObjectId> objects,
                 std::uint64_t* rows) {
  find_rows<2>(boxes, objects, rows);
}
void find_rows_3(std::span<const WideBlock<3>> boxes, std::span<const ObjectId> objects,
                 std::uint64_t* rows) {
  find_rows<3>(boxes, objects, rows);
}

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kerf {

HWY_EXPORT(find_rows_2);
HWY_EXPORT(find_rows_3);

template <>
void overlap_rows<2>(std::span<const WideBlock<2>> boxes, std::span<const ObjectId> objects,
                     std::uint64_t* rows) {
  HWY_DYNAMIC_DISPATCH(find_rows_2)(boxes, objects, rows);
}
template <>
void overlap_rows<3>(std::span<const WideBlock<3>> boxes, std::span<const ObjectId> objects,
                     std::uint64_t* rows) {
  HWY_DYNAMIC_DISPATCH(find_rows_3)(boxes, objects, rows);
}

}  // namespace kerf
#endif
