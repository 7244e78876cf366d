#include "core/kernels/overlap_rows.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/overlap_rows.cpp"
#include <hwy/foreach_target.h>

#include "core/kernels/block_tests-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

/// The bits of a block.
using Part = std::uint16_t;
/// Where the part of a block lies in the word that it is a part of.
constexpr std::size_t kTurn =
    std::endian::native == std::endian::little ? 0 : sizeof(std::uint64_t) / sizeof(Part) - 1;

template <int D>
HWY_INLINE void find_rows(std::span<const WideBlock<D>> boxes, std::span<const ObjectId> objects,
                          bool only_later, std::uint64_t* rows) {
  static_assert(kBlockWidth == 8 * sizeof(Part));
  const std::size_t words = words_of_row(boxes.size());
  for (const ObjectId object : objects) {
    const std::size_t own = object.index() / kBlockWidth;
    const OverlapTest<D> test(boxes[own].box(object.index() % kBlockWidth));
    rows[words - 1] = 0;  // there may be no block for its last part
    auto* const row = reinterpret_cast<std::uint8_t*>(rows);
    for (std::size_t block = only_later ? own : 0; block < boxes.size(); ++block) {
      std::uint32_t bits = 0;
      for (std::size_t k = 0; k < kBlockWidth; k += kPart) bits |= bits_of(test(boxes[block], k)) << k;
      const auto part = static_cast<Part>(bits);
      std::memcpy(row + (block ^ kTurn) * sizeof(Part), &part, sizeof(Part));
    }
    rows += words;
  }
}

void find_rows_2(std::span<const WideBlock<2>> boxes, std::span<const ObjectId> objects, bool only_later,
                 std::uint64_t* rows) {
  find_rows<2>(boxes, objects, only_later, rows);
}
void find_rows_3(std::span<const WideBlock<3>> boxes, std::span<const ObjectId> objects, bool only_later,
                 std::uint64_t* rows) {
  find_rows<3>(boxes, objects, only_later, rows);
}

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kerf {

HWY_EXPORT(find_rows_2);
HWY_EXPORT(find_rows_3);

template <>
void overlap_rows<2>(std::span<const WideBlock<2>> boxes, std::span<const ObjectId> objects, bool only_later,
                     std::uint64_t* rows) {
  HWY_DYNAMIC_DISPATCH(find_rows_2)(boxes, objects, only_later, rows);
}
template <>
void overlap_rows<3>(std::span<const WideBlock<3>> boxes, std::span<const ObjectId> objects, bool only_later,
                     std::uint64_t* rows) {
  HWY_DYNAMIC_DISPATCH(find_rows_3)(boxes, objects, only_later, rows);
}

}  // namespace kerf
#endif
