#include "core/kernels/kept_leaf.h"

#include <algorithm>

#include "core/kernels/prefetch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/kept_leaf.cpp"
#include <hwy/foreach_target.h>

#include "core/kernels/findings-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

template <int D>
HWY_INLINE ByteMap map_of(const KeptLeaf<D>& leaf) {
  const Four four;
  return {hn::LoadU(four, leaf.origin.data()), hn::LoadU(four, leaf.scale.data())};
}

template <int D>
HWY_INLINE ByteKey<D> key_of(const ByteMap& map, const PackedBox<D>& box) {
  const Ends ends = load_ends(box);
  return byte_key<D>(map(ends.min), map(hn::Neg(ends.minus_max)));
}

/// Byte k of a key: min of each axis, then max.
template <int D>
HWY_INLINE std::uint8_t byte_of(ByteKey<D> key, std::size_t k) {
  return static_cast<std::uint8_t>(key >> (8U * (k < D ? k : k - D + PackedBox<D>::kHalf)));
}

template <int D>
HWY_INLINE void store_key(KeptLeaf<D>& leaf, std::size_t place, ByteKey<D> key) {
  for (std::size_t k = 0; k < 2 * D; ++k) leaf.plane(k)[place] = byte_of<D>(key, k);
}

template <int D>
HWY_INLINE void set_map(const LeafView<D>& view, KeptLeaf<D>& leaf) {
  const Four four;
  const ByteMap map = make_byte_map(view);
  hn::StoreU(map.origin, four, leaf.origin.data());
  hn::StoreU(map.scale, four, leaf.scale.data());
}

template <int D>
HWY_INLINE void append(const LeafView<D>& view, KeptLeaf<D>& leaf) {
  const ByteMap map = map_of(leaf);
  for (std::size_t i = 0; i < view.size(); ++i)
    store_key(leaf, leaf.objects.size() + i, key_of(map, view.boxes[i]));
}

template <int D>
HWY_INLINE Probe<D> make_probe(KeptLeaf<D>& leaf, std::size_t place) {
  const Bytes bytes;
  Probe<D> probe;
  for (std::size_t k = 0; k < D; ++k) {
    probe.other_min[k] = leaf.plane(k);
    probe.other_max[k] = leaf.plane(D + k);
    probe.min[k] = hn::Set(bytes, leaf.plane(k)[place]);
    probe.max[k] = hn::Set(bytes, leaf.plane(D + k)[place]);
  }
  return probe;
}

/// Looks the last entries up among those before each.
template <int D>
HWY_INLINE void probe_all(KeptLeaf<D>& leaf, std::size_t count, const PackedBox<D>* boxes, Findings& found,
                          PairBuffer& pairs) {
  const auto entries = [objects = leaf.objects.data(), apart = leaf.apart.data(), boxes](std::uint32_t k) {
    return EntryRef<D>{boxes[objects[k]], objects[k], apart[k]};
  };
  const auto n = static_cast<std::uint32_t>(leaf.objects.size());
  Found rows(found);
  for (auto i = static_cast<std::uint32_t>(n - count); i < n; ++i) {
    const Probe<D> probe = make_probe<D>(leaf, i);
    for (std::uint32_t j = 0; j < i; j += 64) {
      rows.add(overlap_bits(probe, j) & first_bits(i - j), i, j);
      if (rows.is_full()) rows.confirm<D>(entries, entries, pairs);
    }
  }
  rows.confirm<D>(entries, entries, pairs);
}

/// The first of `n` numbers from `k` on that is `wanted`, or n.
HWY_INLINE std::size_t find_number(const std::uint32_t* numbers, std::size_t k, std::size_t n,
                                   std::uint32_t wanted) {
  const hn::ScalableTag<std::uint32_t> lanes;
  const std::size_t step = hn::Lanes(lanes);
  const auto all = hn::Set(lanes, wanted);
  while (k + step <= n && hn::AllFalse(lanes, hn::Eq(hn::LoadU(lanes, numbers + k), all))) k += step;
  while (k < n && numbers[k] != wanted) ++k;
  return k;
}

/// What the last pair replaces is looked at again, so that the order of the pairs left does not depend on the
/// width of the vectors.
void drop_pairs(std::vector<Pair>& pairs, std::uint32_t object) {
  static_assert(sizeof(Pair) == 2 * sizeof(std::uint32_t));
  const auto* const numbers = reinterpret_cast<const std::uint32_t*>(pairs.data());
  std::size_t n = pairs.size();
  for (std::size_t at = find_number(numbers, 0, 2 * n, object); at < 2 * n;
       at = find_number(numbers, at & ~std::size_t{1}, 2 * n, object))
    pairs[at / 2] = pairs[--n];
  pairs.resize(n);
}

std::size_t find_object(const std::vector<std::uint32_t>& objects, std::uint32_t object) {
  return find_number(objects.data(), 0, objects.size(), object);
}

/// No branch depends on the outcome.
template <bool Far, int D>
HWY_INLINE std::size_t filter_to(Pair* HWY_RESTRICT out, std::span<const Pair> candidates,
                                 std::span<const PackedBox<D>> boxes) {
  std::size_t written = 0;
  const auto keep_if_true = [&](std::size_t k) HWY_ATTR {
    if constexpr (Far) {
      const Pair& ahead = candidates[std::min(k + kPrefetchAhead, candidates.size() - 1)];
      prefetch(&boxes[ahead.a.index()]);
      prefetch(&boxes[ahead.b.index()]);
    }
    const Pair& pair = candidates[k];
    const bool overlap = boxes_overlap<D>(boxes[pair.a.index()], boxes[pair.b.index()]);
    out[written] = pair;
    written += static_cast<std::size_t>(overlap);
  };
  std::size_t k = 0;
  for (; k + 4 <= candidates.size(); k += 4) {
    keep_if_true(k);
    keep_if_true(k + 1);
    keep_if_true(k + 2);
    keep_if_true(k + 3);
  }
  for (; k < candidates.size(); ++k) keep_if_true(k);
  return written;
}

template <int D>
HWY_INLINE void filter(std::span<const Pair> candidates, std::span<const PackedBox<D>> boxes,
                       PairBuffer& pairs) {
  Pair* const out = pairs.reserve(candidates.size());
  pairs.commit(exceeds(boxes, kOwnPages) ? filter_to<true, D>(out, candidates, boxes)
                                         : filter_to<false, D>(out, candidates, boxes));
}

void set_map_2(const LeafView<2>& view, KeptLeaf<2>& leaf) { set_map(view, leaf); }
void set_map_3(const LeafView<3>& view, KeptLeaf<3>& leaf) { set_map(view, leaf); }
void append_2(const LeafView<2>& view, KeptLeaf<2>& leaf) { append(view, leaf); }
void append_3(const LeafView<3>& view, KeptLeaf<3>& leaf) { append(view, leaf); }
void probe_2(KeptLeaf<2>& leaf, std::size_t count, const PackedBox<2>* boxes, Findings& found,
             PairBuffer& pairs) {
  probe_all(leaf, count, boxes, found, pairs);
}
void probe_3(KeptLeaf<3>& leaf, std::size_t count, const PackedBox<3>* boxes, Findings& found,
             PairBuffer& pairs) {
  probe_all(leaf, count, boxes, found, pairs);
}
void filter_2(std::span<const Pair> candidates, std::span<const PackedBox<2>> boxes, PairBuffer& pairs) {
  filter(candidates, boxes, pairs);
}
void filter_3(std::span<const Pair> candidates, std::span<const PackedBox<3>> boxes, PairBuffer& pairs) {
  filter(candidates, boxes, pairs);
}

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kerf {
namespace {

constexpr std::size_t kPad = 64;  // bytes that may be read beyond the end of a plane

HWY_EXPORT(drop_pairs);
HWY_EXPORT(find_object);
HWY_EXPORT(set_map_2);
HWY_EXPORT(set_map_3);
HWY_EXPORT(append_2);
HWY_EXPORT(append_3);
HWY_EXPORT(probe_2);
HWY_EXPORT(probe_3);
HWY_EXPORT(filter_2);
HWY_EXPORT(filter_3);

/// Makes the planes long enough for `n` entries and a whole vector behind them.
template <int D>
void make_room(KeptLeaf<D>& leaf, std::size_t n) {
  if (n + kPad <= leaf.stride) return;
  const std::size_t stride = n + n / 4 + kPad;
  std::vector<std::uint8_t> planes(stride * 2 * D);
  for (std::size_t k = 0; k < std::size_t{2} * D; ++k)
    std::copy_n(leaf.plane(k), leaf.objects.size(), planes.data() + k * stride);
  leaf.planes = std::move(planes);
  leaf.stride = stride;
}

}  // namespace

template <int D>
void empty_leaf(const LeafView<D>& view, KeptLeaf<D>& leaf) {
  leaf.objects.clear();
  leaf.apart.clear();
  leaf.sure.clear();
  leaf.candidates.clear();
  leaf.restless.clear();
  if constexpr (D == 2) {
    HWY_DYNAMIC_DISPATCH(set_map_2)(view, leaf);
  } else {
    HWY_DYNAMIC_DISPATCH(set_map_3)(view, leaf);
  }
}

template <int D>
void append_entries(const LeafView<D>& view, KeptLeaf<D>& leaf) {
  make_room(leaf, leaf.objects.size() + view.size());
  if constexpr (D == 2) {
    HWY_DYNAMIC_DISPATCH(append_2)(view, leaf);
  } else {
    HWY_DYNAMIC_DISPATCH(append_3)(view, leaf);
  }
  for (const ObjectId object : view.objects) leaf.objects.push_back(object.value);
  leaf.apart.insert(leaf.apart.end(), view.apart.begin(), view.apart.end());
}

template <int D>
void drop_entry(KeptLeaf<D>& leaf, std::size_t k) {
  const std::size_t last = leaf.objects.size() - 1;
  leaf.objects[k] = leaf.objects[last];
  leaf.apart[k] = leaf.apart[last];
  for (std::size_t p = 0; p < std::size_t{2} * D; ++p) leaf.plane(p)[k] = leaf.plane(p)[last];
  leaf.objects.pop_back();
  leaf.apart.pop_back();
}

template <int D>
void drop_object(KeptLeaf<D>& leaf, std::uint32_t object) {
  const std::size_t k = HWY_DYNAMIC_DISPATCH(find_object)(leaf.objects, object);
  if (k == leaf.objects.size()) return;
  drop_entry(leaf, k);
  HWY_DYNAMIC_DISPATCH(drop_pairs)(leaf.sure, object);
  HWY_DYNAMIC_DISPATCH(drop_pairs)(leaf.candidates, object);
}

template <int D>
void drop_last(KeptLeaf<D>& leaf, std::size_t count) {
  leaf.objects.resize(leaf.objects.size() - count);
  leaf.apart.resize(leaf.objects.size());
}

template <int D>
void probe_last(KeptLeaf<D>& leaf, std::size_t count, std::span<const PackedBox<D>> boxes, Findings& found,
                PairBuffer& pairs) {
  if constexpr (D == 2) {
    HWY_DYNAMIC_DISPATCH(probe_2)(leaf, count, boxes.data(), found, pairs);
  } else {
    HWY_DYNAMIC_DISPATCH(probe_3)(leaf, count, boxes.data(), found, pairs);
  }
}

template <int D>
void filter_pairs(std::span<const Pair> candidates, std::span<const PackedBox<D>> boxes, PairBuffer& pairs) {
  if constexpr (D == 2) {
    HWY_DYNAMIC_DISPATCH(filter_2)(candidates, boxes, pairs);
  } else {
    HWY_DYNAMIC_DISPATCH(filter_3)(candidates, boxes, pairs);
  }
}

#define KERF_INSTANTIATE(D)                                                                        \
  template void empty_leaf<D>(const LeafView<D>&, KeptLeaf<D>&);                                   \
  template void append_entries<D>(const LeafView<D>&, KeptLeaf<D>&);                               \
  template void drop_object<D>(KeptLeaf<D>&, std::uint32_t);                                       \
  template void drop_entry<D>(KeptLeaf<D>&, std::size_t);                                          \
  template void drop_last<D>(KeptLeaf<D>&, std::size_t);                                           \
  template void probe_last<D>(KeptLeaf<D>&, std::size_t, std::span<const PackedBox<D>>, Findings&, \
                              PairBuffer&);                                                        \
  template void filter_pairs<D>(std::span<const Pair>, std::span<const PackedBox<D>>, PairBuffer&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
#endif
