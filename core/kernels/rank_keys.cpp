#include "core/kernels/rank_keys.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/kernels/sort_scalars.h"

namespace kerf {
namespace {

/// How many of the numbers are at most x. No branch depends on them.
std::uint32_t rank_of(Scalar x, const std::array<Scalar, RankScale<2>::kRanks>& ascending) {
  std::uint32_t rank = 0;
  for (std::uint32_t half = 128; half > 0; half /= 2)
    rank += half & (0U - static_cast<std::uint32_t>(ascending[rank + half - 1] <= x));
  return rank;
}

}  // namespace

template <int D>
RankScale<D> make_rank_scale(std::span<const PackedBox<D>> boxes) {
  RankScale<D> scale;
  const std::size_t count = std::min(boxes.size(), RankScale<D>::kRanks);
  for (std::size_t axis = 0; axis < D; ++axis) {
    auto& beginnings = scale.beginnings[axis];
    beginnings.fill(std::numeric_limits<Scalar>::infinity());
    for (std::size_t k = 0; k < count; ++k) beginnings[k] = boxes[k * boxes.size() / count].lane[axis];
    sort_scalars({beginnings.data(), count});
  }
  return scale;
}

template <int D>
ByteKey<D> rank_key(const PackedBox<D>& box, const RankScale<D>& scale) {
  constexpr std::size_t kHalf = PackedBox<D>::kHalf;
  ByteKey<D> key = 0;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const ByteKey<D> begin = rank_of(box.lane[axis], scale.beginnings[axis]);
    const ByteKey<D> end = rank_of(-box.lane[kHalf + axis], scale.beginnings[axis]);
    key |= begin << (8 * axis) | end << (8 * (kHalf + axis));
  }
  return key;
}

template <int D>
void move_scale(RankScale<D>& scale, const Vector<D>& by) {
  for (int axis = 0; axis < D; ++axis)
    for (Scalar& beginning : scale.beginnings[static_cast<std::size_t>(axis)]) beginning += by[axis];
}

#define KERF_INSTANTIATE(D)                                                  \
  template RankScale<D> make_rank_scale<D>(std::span<const PackedBox<D>>);   \
  template ByteKey<D> rank_key<D>(const PackedBox<D>&, const RankScale<D>&); \
  template void move_scale<D>(RankScale<D>&, const Vector<D>&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
