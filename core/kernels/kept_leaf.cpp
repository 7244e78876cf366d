#include "core/kernels/kept_leaf.h"

#include <algorithm>
#include <array>
#include <memory>

#include "core/base/list_room.h"
#include "core/base/tuning.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/kept_leaf.cpp"
#include <hwy/foreach_target.h>

#include "core/kernels/findings-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

/// Byte k of a key: min of each axis, then max.
template <int D>
HWY_INLINE std::uint8_t byte_of(ByteKey<D> key, std::size_t k) {
  return static_cast<std::uint8_t>(key >> (8U * (k < D ? k : k - D + PackedBox<D>::kHalf)));
}

template <int D>
HWY_INLINE void store_key(KeptLeaf<D>& leaf, std::size_t place, ByteKey<D> key) {
  for (std::size_t k = 0; k < 2 * D; ++k) leaf.plane(k)[place] = byte_of<D>(key, k);
}

/// Makes the bytes of the entries from a place on.
template <int D>
HWY_INLINE void store_keys(std::span<const PackedBox<D>> boxes, std::size_t from, KeptLeaf<D>& leaf) {
  if (leaf.ranks) {
    for (std::size_t i = 0; i < boxes.size(); ++i) store_key(leaf, from + i, rank_key(boxes[i], *leaf.ranks));
    return;
  }
  const ByteMap<D> map(leaf.bytes);
  for (std::size_t i = 0; i < boxes.size(); ++i) store_key(leaf, from + i, byte_key<D>(map(boxes[i])));
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

/// Not inlined, and takes the findings by value: the loop that calls it then keeps everything in registers.
template <bool Places, int D>
HWY_NOINLINE void confirm_in(const KeptLeaf<D>& leaf, const LeafView<D>& last, const PackedBox<D>* boxes,
                             Found found, PairBuffer& pairs) {
  const auto entry = [objects = leaf.objects.data(), apart = leaf.apart.data(), boxes](std::uint32_t k)
                         HWY_ATTR {
                           return EntryRef<D>{boxes[objects[k]], Places ? k : objects[k], apart[k]};
                         };
  const auto row = [objects = leaf.objects.data(), apart = leaf.apart.data(), boxes = last.boxes.data(),
                    begin = leaf.objects.size() - last.size()](std::uint32_t k) HWY_ATTR {
    return EntryRef<D>{boxes[k - begin], Places ? k : objects[k], apart[k]};
  };
  confirm<D>(found, row, entry, pairs);
}

/// Looks up each of the last entries among those before it.
template <bool Places, int D>
HWY_INLINE void probe_all(KeptLeaf<D>& leaf, const LeafView<D>& last, const PackedBox<D>* boxes,
                          Findings& room, PairBuffer& pairs) {
  const auto n = static_cast<std::uint32_t>(leaf.objects.size());
  Found found(room);
  for (auto i = static_cast<std::uint32_t>(n - last.size()); i < n; ++i) {
    const Probe<D> probe = make_probe<D>(leaf, i);
    for (std::uint32_t j = 0; j < i; j += 64) {
      found.add(overlap_bits(probe, j) & first_bits(i - j), i, j);
      if (!found.is_full()) continue;
      confirm_in<Places>(leaf, last, boxes, found, pairs);
      found.clear();
    }
  }
  confirm_in<Places>(leaf, last, boxes, found, pairs);
}

/// The first of `n` numbers from `k` on that is one of those wanted, or n.
template <std::size_t N>
HWY_INLINE std::size_t find_number(const std::uint32_t* numbers, std::size_t k, std::size_t n,
                                   const std::array<std::uint32_t, N>& wanted) {
  const hn::ScalableTag<std::uint32_t> lanes;
  const std::size_t step = hn::Lanes(lanes);
  for (; k + step <= n; k += step) {
    const auto some = hn::LoadU(lanes, numbers + k);
    auto is_wanted = hn::Eq(some, hn::Set(lanes, wanted[0]));
    for (std::size_t i = 1; i < N; ++i)
      is_wanted = hn::Or(is_wanted, hn::Eq(some, hn::Set(lanes, wanted[i])));
    if (const auto first = hn::FindFirstTrue(lanes, is_wanted); first >= 0)
      return k + static_cast<std::size_t>(first);
  }
  while (k < n && std::ranges::find(wanted, numbers[k]) == wanted.end()) ++k;
  return k;
}

/// Drops the pairs of these names, and records where others are now. A pair that replaces another one is
/// tested again, so that the order of the remaining pairs does not depend on the width of the vectors.
template <std::size_t N>
HWY_INLINE void drop_pairs_of(const std::array<std::uint32_t, N>& names, std::vector<Pair>& pairs,
                              std::vector<std::uint32_t>* changed) {
  static_assert(sizeof(Pair) == 2 * sizeof(std::uint32_t));
  const auto* const numbers = reinterpret_cast<const std::uint32_t*>(pairs.data());
  std::size_t n = pairs.size();
  for (std::size_t at = find_number(numbers, 0, 2 * n, names); at < 2 * n;
       at = find_number(numbers, at & ~std::size_t{1}, 2 * n, names)) {
    pairs[at / 2] = pairs[--n];
    if (changed != nullptr) changed->push_back(static_cast<std::uint32_t>(at / 2));
  }
  pairs.resize(n);
}

/// Long lists are read from afar: once for four names.
void drop_pairs(std::vector<Pair>& pairs, std::span<const std::uint32_t> names,
                std::vector<std::uint32_t>* changed) {
  constexpr std::size_t kAtOnce = 4;
  for (; names.size() > 1; names = names.subspan(std::min(kAtOnce, names.size()))) {
    std::array<std::uint32_t, kAtOnce> some;
    for (std::size_t i = 0; i < kAtOnce; ++i) some[i] = names[std::min(i, names.size() - 1)];
    drop_pairs_of(some, pairs, changed);
  }
  if (!names.empty()) drop_pairs_of(std::array{names.front()}, pairs, changed);
}

void rename(std::vector<Pair>& pairs, std::uint32_t from, std::uint32_t to) {
  auto* const numbers = reinterpret_cast<std::uint32_t*>(pairs.data());
  const std::size_t n = 2 * pairs.size();
  const std::array wanted{from};
  for (std::size_t at = find_number(numbers, 0, n, wanted); at < n;
       at = find_number(numbers, at + 1, n, wanted))
    numbers[at] = to;
}

std::size_t find_object(const std::vector<std::uint32_t>& objects, std::uint32_t object) {
  return find_number(objects.data(), 0, objects.size(), std::array{object});
}

ByteScale<2> scale_2(const LeafView<2>& view) { return make_byte_scale(view); }
ByteScale<3> scale_3(const LeafView<3>& view) { return make_byte_scale(view); }
void store_2(std::span<const PackedBox<2>> boxes, std::size_t from, KeptLeaf<2>& leaf) {
  store_keys(boxes, from, leaf);
}
void store_3(std::span<const PackedBox<3>> boxes, std::size_t from, KeptLeaf<3>& leaf) {
  store_keys(boxes, from, leaf);
}
template <int D>
HWY_INLINE void probe(KeptLeaf<D>& leaf, const LeafView<D>& last, const PackedBox<D>* boxes, Names names,
                      Findings& found, PairBuffer& pairs) {
  names == Names::places ? probe_all<true>(leaf, last, boxes, found, pairs)
                         : probe_all<false>(leaf, last, boxes, found, pairs);
}
void probe_2(KeptLeaf<2>& leaf, const LeafView<2>& last, const PackedBox<2>* boxes, Names names,
             Findings& found, PairBuffer& pairs) {
  probe(leaf, last, boxes, names, found, pairs);
}
void probe_3(KeptLeaf<3>& leaf, const LeafView<3>& last, const PackedBox<3>* boxes, Names names,
             Findings& found, PairBuffer& pairs) {
  probe(leaf, last, boxes, names, found, pairs);
}

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kerf {
namespace {

constexpr std::size_t kPad = 64;  // bytes that may be read beyond the end of a plane

HWY_EXPORT(drop_pairs);
HWY_EXPORT(rename);
HWY_EXPORT(find_object);
HWY_EXPORT(scale_2);
HWY_EXPORT(scale_3);
HWY_EXPORT(store_2);
HWY_EXPORT(store_3);
HWY_EXPORT(probe_2);
HWY_EXPORT(probe_3);

/// Makes the planes long enough for `n` entries and a whole vector behind them.
template <int D>
void make_room(KeptLeaf<D>& leaf, std::size_t n) {
  if (n + kPad <= leaf.stride) return;
  const std::size_t stride = n + n / tuning::kEntriesPerSpare + kPad;
  std::vector<std::uint8_t> planes(stride * 2 * D);
  for (std::size_t k = 0; k < std::size_t{2} * D; ++k)
    std::copy_n(leaf.plane(k), leaf.objects.size(), planes.data() + k * stride);
  leaf.planes = std::move(planes);
  leaf.stride = stride;
}

/// No branch depends on the outcome.
template <class Goes>
void drop_pairs_if(std::vector<Pair>& pairs, Goes goes) {
  std::size_t written = 0;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const Pair pair = pairs[k];
    pairs[written] = pair;
    written += goes(pair) == 0 ? 1 : 0;
  }
  pairs.resize(written);
}

template <int D>
void store(std::span<const PackedBox<D>> boxes, std::size_t from, KeptLeaf<D>& leaf) {
  if constexpr (D == 2) {
    HWY_DYNAMIC_DISPATCH(store_2)(boxes, from, leaf);
  } else {
    HWY_DYNAMIC_DISPATCH(store_3)(boxes, from, leaf);
  }
}

template <int D>
void move_entry(KeptLeaf<D>& leaf, std::size_t from, std::size_t to) {
  leaf.objects[to] = leaf.objects[from];
  leaf.apart[to] = leaf.apart[from];
  for (std::size_t p = 0; p < std::size_t{2} * D; ++p) leaf.plane(p)[to] = leaf.plane(p)[from];
}

}  // namespace

template <int D>
void empty_leaf(const LeafView<D>& view, KeptLeaf<D>& leaf) {
  leaf.bytes_stale = false;
  leaf.ranks.reset();
  leaf.objects.clear();
  leaf.apart.clear();
  leaf.resting.pairs.clear();
  leaf.candidates.clear();
  leaf.near.clear();
  leaf.restless.clear();
  if constexpr (D == 2) {
    leaf.bytes = HWY_DYNAMIC_DISPATCH(scale_2)(view);
  } else {
    leaf.bytes = HWY_DYNAMIC_DISPATCH(scale_3)(view);
  }
}

template <int D>
void rank_bytes(const LeafView<D>& view, KeptLeaf<D>& leaf) {
  leaf.ranks = std::make_unique<RankScale<D>>(make_rank_scale<D>(view.boxes));
  leaf.bytes_stale = true;
}

template <int D>
void move_bytes(const Vector<D>& by, KeptLeaf<D>& leaf) {
  leaf.bytes.origin = moved(leaf.bytes.origin, PackedBox<D>({by, by}));
  if (leaf.ranks) move_scale(*leaf.ranks, by);
  leaf.bytes_stale = true;
}

template <int D>
void append_entries(const LeafView<D>& view, KeptLeaf<D>& leaf) {
  make_room(leaf, leaf.objects.size() + view.size());
  store<D>(view.boxes, leaf.objects.size(), leaf);
  if (leaf.objects.empty()) {  // most leaves get no more
    leaf.objects.reserve(view.size());
    leaf.apart.reserve(view.size());
  }
  grow_list(leaf.objects, leaf.objects.size() + view.size());
  grow_list(leaf.apart, leaf.apart.size() + view.size());
  for (const ObjectId object : view.objects) leaf.objects.push_back(object.value);
  leaf.apart.insert(leaf.apart.end(), view.apart.begin(), view.apart.end());
}

template <int D>
void renew_bytes(KeptLeaf<D>& leaf, std::span<const PackedBox<D>> boxes,
                 std::vector<PackedBox<D>>& gathered) {
  if (!leaf.bytes_stale) return;
  leaf.bytes_stale = false;
  gathered.clear();
  for (const std::uint32_t object : leaf.objects) gathered.push_back(boxes[object]);
  store<D>(gathered, 0, leaf);
}

template <int D>
void drop_objects(KeptLeaf<D>& leaf, std::span<const std::uint32_t> objects) {
  for (const std::uint32_t object : objects) {
    const auto place = static_cast<std::uint32_t>(HWY_DYNAMIC_DISPATCH(find_object)(leaf.objects, object));
    if (place == leaf.objects.size()) continue;
    const auto last = static_cast<std::uint32_t>(leaf.objects.size() - 1);
    move_entry(leaf, last, place);
    drop_last(leaf, 1);
    if (leaf.names == Names::objects) continue;
    HWY_DYNAMIC_DISPATCH(drop_pairs)(leaf.candidates, {&place, 1}, nullptr);
    HWY_DYNAMIC_DISPATCH(rename)(leaf.candidates, last, place);
  }
  HWY_DYNAMIC_DISPATCH(drop_pairs)(leaf.resting.pairs, objects, &leaf.resting.changed);
  HWY_DYNAMIC_DISPATCH(drop_pairs)(leaf.near, objects, nullptr);
  if (leaf.names == Names::objects) HWY_DYNAMIC_DISPATCH(drop_pairs)(leaf.candidates, objects, nullptr);
}

template <int D>
void drop_marked(KeptLeaf<D>& leaf, std::span<const std::uint8_t> marks) {
  const auto mark_of = [&](ObjectId name) {
    return marks[leaf.names == Names::places ? leaf.objects[name.index()] : name.value];
  };
  const std::size_t before = leaf.objects.size();
  drop_pairs_if(leaf.candidates, [&](const Pair& pair) { return mark_of(pair.a) | mark_of(pair.b); });
  const auto is_marked = [&](const Pair& pair) { return marks[pair.a.index()] | marks[pair.b.index()]; };
  drop_pairs_if(leaf.resting.pairs, is_marked);
  drop_pairs_if(leaf.near, is_marked);
  leaf.resting.all_changed();  // nearly all
  std::vector<std::uint32_t> place(before);
  std::uint32_t left = 0;
  for (std::size_t k = 0; k < before; ++k) {
    place[k] = left;
    if (marks[leaf.objects[k]] == 0) move_entry(leaf, k, left++);
  }
  drop_last(leaf, before - left);
  if (leaf.names == Names::objects) return;
  for (Pair& pair : leaf.candidates) pair = {{place[pair.a.index()]}, {place[pair.b.index()]}};
}

template <int D>
void drop_last(KeptLeaf<D>& leaf, std::size_t count) {
  leaf.objects.resize(leaf.objects.size() - count);
  leaf.apart.resize(leaf.objects.size());
}

template <int D>
void probe_last(KeptLeaf<D>& leaf, const LeafView<D>& last, std::span<const PackedBox<D>> boxes, Names names,
                Findings& found, PairBuffer& pairs) {
  if constexpr (D == 2) {
    HWY_DYNAMIC_DISPATCH(probe_2)(leaf, last, boxes.data(), names, found, pairs);
  } else {
    HWY_DYNAMIC_DISPATCH(probe_3)(leaf, last, boxes.data(), names, found, pairs);
  }
}

#define KERF_INSTANTIATE(D)                                                                              \
  template void empty_leaf<D>(const LeafView<D>&, KeptLeaf<D>&);                                         \
  template void rank_bytes<D>(const LeafView<D>&, KeptLeaf<D>&);                                         \
  template void move_bytes<D>(const Vector<D>&, KeptLeaf<D>&);                                           \
  template void append_entries<D>(const LeafView<D>&, KeptLeaf<D>&);                                     \
  template void drop_objects<D>(KeptLeaf<D>&, std::span<const std::uint32_t>);                           \
  template void drop_marked<D>(KeptLeaf<D>&, std::span<const std::uint8_t>);                             \
  template void drop_last<D>(KeptLeaf<D>&, std::size_t);                                                 \
  template void renew_bytes<D>(KeptLeaf<D>&, std::span<const PackedBox<D>>, std::vector<PackedBox<D>>&); \
  template void probe_last<D>(KeptLeaf<D>&, const LeafView<D>&, std::span<const PackedBox<D>>, Names,    \
                              Findings&, PairBuffer&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
#endif
