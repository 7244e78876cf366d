#include "core/kernels/filter_candidates.h"

#include <algorithm>

#include "core/base/tuning.h"
#include "core/kernels/prefetch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/filter_candidates.cpp"
#include <hwy/foreach_target.h>

#include "core/kernels/four_pairs-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

/// Writes those of the candidates whose boxes, given by their names, overlap. Four in each turn of the loop:
/// then its place in memory matters least. No branch depends on the outcome.
template <int D>
HWY_INLINE std::size_t filter_to(Pair* HWY_RESTRICT out, std::span<const Pair> candidates,
                                 const PackedBox<D>* boxes) {
  std::size_t written = 0;
  const auto keep_if_true = [&](const Pair& pair) HWY_ATTR {
    const bool overlap = boxes_overlap<D>(boxes[pair.a.index()], boxes[pair.b.index()]);
    out[written] = pair;
    written += static_cast<std::size_t>(overlap);
  };
  std::size_t k = 0;
  for (; k + 4 <= candidates.size(); k += 4) {
    const Pair* const four = candidates.data() + k;
#if KERF_HAS_FOUR_PAIRS
    const auto apart_of = [boxes](const Pair& pair)
                              HWY_ATTR { return apart<D>(boxes[pair.a.index()], boxes[pair.b.index()]); };
    const Packed<D> lanes[4] = {apart_of(four[0]), apart_of(four[1]), apart_of(four[2]), apart_of(four[3])};
    written += write_chosen(load_pairs(four), nowhere_of_four<D>(lanes), out + written);
#else
    keep_if_true(four[0]);
    keep_if_true(four[1]);
    keep_if_true(four[2]);
    keep_if_true(four[3]);
#endif
  }
  for (; k < candidates.size(); ++k) keep_if_true(candidates[k]);
  return written;
}

template <int D>
HWY_INLINE const PackedBox<D>* gather(const std::vector<std::uint32_t>& objects, const PackedBox<D>* boxes,
                                      std::vector<PackedBox<D>>& gathered) {
  const std::size_t n = objects.size();
  gathered.resize(std::max(gathered.size(), n));
  for (std::size_t k = 0; k < n; ++k) {
    prefetch(boxes + objects[std::min(k + tuning::kPrefetchAhead, n - 1)]);
    gathered[k] = boxes[objects[k]];
  }
  return gathered.data();
}

template <int D>
HWY_INLINE void filter(const KeptLeaf<D>& leaf, const PackedBox<D>* boxes,
                       std::vector<PackedBox<D>>& gathered, PairBuffer& pairs) {
  if (leaf.candidates.empty()) return;
  Pair* const out = pairs.reserve(leaf.candidates.size());
  if (leaf.names == Names::objects) {
    pairs.commit(filter_to(out, leaf.candidates, boxes));
  } else {
    const std::size_t written = filter_to(out, leaf.candidates, gather(leaf.objects, boxes, gathered));
    for (std::size_t k = 0; k < written; ++k)
      out[k] = {{leaf.objects[out[k].a.index()]}, {leaf.objects[out[k].b.index()]}};
    pairs.commit(written);
  }
}

void filter_2(const KeptLeaf<2>& leaf, const PackedBox<2>* boxes, std::vector<PackedBox<2>>& gathered,
              PairBuffer& pairs) {
  filter(leaf, boxes, gathered, pairs);
}
void filter_3(const KeptLeaf<3>& leaf, const PackedBox<3>* boxes, std::vector<PackedBox<3>>& gathered,
              PairBuffer& pairs) {
  filter(leaf, boxes, gathered, pairs);
}

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kerf {
namespace {

HWY_EXPORT(filter_2);
HWY_EXPORT(filter_3);

}  // namespace

template <int D>
void filter_candidates(const KeptLeaf<D>& leaf, std::span<const PackedBox<D>> boxes,
                       std::vector<PackedBox<D>>& gathered, PairBuffer& pairs) {
  if constexpr (D == 2) {
    HWY_DYNAMIC_DISPATCH(filter_2)(leaf, boxes.data(), gathered, pairs);
  } else {
    HWY_DYNAMIC_DISPATCH(filter_3)(leaf, boxes.data(), gathered, pairs);
  }
}

#define KERF_INSTANTIATE(D)                                                             \
  template void filter_candidates<D>(const KeptLeaf<D>&, std::span<const PackedBox<D>>, \
                                     std::vector<PackedBox<D>>&, PairBuffer&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
#endif
