#include "core/kernels/kept_leaf.h"

#include <algorithm>
#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/kernels/kept_leaf.cpp"
#include <hwy/foreach_target.h>

#include "core/kernels/bytes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kerf::HWY_NAMESPACE {

template <int D>
HWY_INLINE ByteMap map_of(const KeptLeaf<D>& leaf) {
  const Four four;
  return {hn::LoadU(four, leaf.origin.data()), hn::LoadU(four, leaf.scale.data())};
}

template <int D>
HWY_INLINE auto key_of(const ByteMap& map, const PackedBox<D>& box) {
  const Ends ends = load_ends(box);
  return byte_key<D>(map(ends.min), map(hn::Neg(ends.minus_max)));
}

/// Byte k of a key: min of each axis, then max.
template <int D, class Key>
HWY_INLINE std::uint8_t byte_of(Key key, std::size_t k) {
  return static_cast<std::uint8_t>(key >> (8U * (k < D ? k : k - D + PackedBox<D>::kHalf)));
}

template <int D, class Key>
HWY_INLINE void store_key(KeptLeaf<D>& leaf, std::size_t place, Key key) {
  for (std::size_t k = 0; k < 2 * D; ++k) leaf.plane(k)[place] = byte_of<D>(key, k);
}

template <int D>
HWY_INLINE void keep(const LeafView<D>& view, KeptLeaf<D>& leaf) {
  const Four four;
  const ByteMap map = make_byte_map(view);
  hn::StoreU(map.origin, four, leaf.origin.data());
  hn::StoreU(map.scale, four, leaf.scale.data());
  for (std::size_t i = 0; i < view.size(); ++i) store_key(leaf, i, key_of(map, view.boxes[i]));
}

/// Appends the partners of `box` to the rows and gives their number.
template <int D, class Key>
HWY_INLINE std::uint32_t find_partners(KeptLeaf<D>& leaf, const PackedBox<D>& box, Key key, DepthMask apart,
                                       const PackedBox<D>* boxes) {
  const Bytes bytes;
  Probe<D> probe;
  for (std::size_t k = 0; k < D; ++k) {
    probe.other_min[k] = leaf.plane(k);
    probe.other_max[k] = leaf.plane(D + k);
    probe.min[k] = hn::Set(bytes, byte_of<D>(key, k));
    probe.max[k] = hn::Set(bytes, byte_of<D>(key, D + k));
  }
  const Ends own = load_ends(box);
  const std::size_t before = leaf.rows.size();
  const std::size_t n = leaf.objects.size();
  for (std::size_t j = 0; j < n; j += 64) {
    std::uint64_t bits = overlap_bits(probe, j);
    if (n - j < 64) bits &= (std::uint64_t{1} << (n - j)) - 1;
    for (; bits != 0; bits &= bits - 1) {
      const std::size_t at = j + static_cast<std::size_t>(std::countr_zero(bits));
      const std::uint32_t other = leaf.objects[at];
      if ((leaf.apart[at] & apart) == 0 && ends_overlap<D>(own, load_ends(boxes[other])))
        leaf.rows.push_back(other);
    }
  }
  return static_cast<std::uint32_t>(leaf.rows.size() - before);
}

template <int D>
HWY_INLINE void add(KeptLeaf<D>& leaf, std::uint32_t object, DepthMask apart, const PackedBox<D>* boxes) {
  const auto key = key_of(map_of(leaf), boxes[object]);
  leaf.rows.push_back(object);
  leaf.rows.push_back(0);
  const std::size_t count_at = leaf.rows.size() - 1;
  const std::uint32_t count = find_partners(leaf, boxes[object], key, apart, boxes);
  leaf.rows[count_at] = count;
  if (count == 0) leaf.rows.resize(leaf.rows.size() - 2);
  store_key(leaf, leaf.objects.size(), key);
  leaf.objects.push_back(object);
  leaf.apart.push_back(apart);
}

/// The owner of a row is loaded once, its ends changed over: a partner overlaps it iff no lane of the partner
/// is greater. No branch depends on the outcome.
template <int D>
HWY_INLINE void filter(std::span<const std::uint32_t> rows, const PackedBox<D>* boxes, PairBuffer& pairs) {
  const Four four;
  const hn::CappedTag<float, 2 * PackedBox<D>::kHalf> wide;
  constexpr std::size_t kLanes = hn::MaxLanes(hn::CappedTag<float, 2 * PackedBox<D>::kHalf>{});
  Pair* const HWY_RESTRICT out = pairs.reserve(rows.size());
  std::size_t written = 0;
  const std::uint32_t* row = rows.data();
  const std::uint32_t* const end = row + rows.size();
  PackedBox<D> limit;
  while (row != end) {
    const std::uint32_t owner = row[0];
    const std::uint32_t* const row_end = row + 2 + row[1];
    const Ends own = load_ends(boxes[owner]);
    hn::Store(hn::Neg(own.minus_max), four, limit.lane.data());
    if constexpr (D == 3) hn::Store(hn::Neg(own.min), four, limit.lane.data() + 4);
    const auto low = hn::Load(wide, limit.lane.data());
    const auto high = hn::Load(wide, limit.lane.data() + limit.lane.size() - kLanes);
    for (row += 2; row != row_end; ++row) {
      const std::uint32_t other = *row;
      const float* const lanes = boxes[other].lane.data();
      auto inside = hn::Le(hn::Load(wide, lanes), low);
      if constexpr (kLanes < 2 * PackedBox<D>::kHalf)
        inside = hn::And(inside, hn::Le(hn::Load(wide, lanes + kLanes), high));
      out[written] = {ObjectId{std::min(owner, other)}, ObjectId{std::max(owner, other)}};
      written += static_cast<std::size_t>(hn::AllTrue(wide, inside));
    }
  }
  pairs.commit(written);
}

void keep_2(const LeafView<2>& view, KeptLeaf<2>& leaf) { keep(view, leaf); }
void keep_3(const LeafView<3>& view, KeptLeaf<3>& leaf) { keep(view, leaf); }
void add_2(KeptLeaf<2>& leaf, std::uint32_t object, DepthMask apart, const PackedBox<2>* boxes) {
  add(leaf, object, apart, boxes);
}
void add_3(KeptLeaf<3>& leaf, std::uint32_t object, DepthMask apart, const PackedBox<3>* boxes) {
  add(leaf, object, apart, boxes);
}
void filter_2(std::span<const std::uint32_t> rows, const PackedBox<2>* boxes, PairBuffer& pairs) {
  filter(rows, boxes, pairs);
}
void filter_3(std::span<const std::uint32_t> rows, const PackedBox<3>* boxes, PairBuffer& pairs) {
  filter(rows, boxes, pairs);
}

}  // namespace kerf::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kerf {
namespace {

constexpr std::size_t kPad = 64;  // bytes that may be read beyond the end of a plane

HWY_EXPORT(keep_2);
HWY_EXPORT(keep_3);
HWY_EXPORT(add_2);
HWY_EXPORT(add_3);
HWY_EXPORT(filter_2);
HWY_EXPORT(filter_3);

/// Makes the planes long enough for `n` entries and a whole vector behind them; what they held is lost if
/// they must grow, unless `keep_bytes`.
template <int D>
void make_room(KeptLeaf<D>& leaf, std::size_t n, bool keep_bytes) {
  if (n + kPad <= leaf.stride) return;
  const std::size_t stride = n + n / 4 + kPad;
  std::vector<std::uint8_t> planes(stride * 2 * D);
  if (keep_bytes)
    for (std::size_t k = 0; k < std::size_t{2} * D; ++k)
      std::copy_n(leaf.plane(k), leaf.objects.size(), planes.data() + k * stride);
  leaf.planes = std::move(planes);
  leaf.stride = stride;
}

}  // namespace

template <int D>
void keep_entries(const LeafView<D>& view, KeptLeaf<D>& leaf) {
  make_room(leaf, view.size(), false);
  leaf.objects.clear();
  for (const ObjectId object : view.objects) leaf.objects.push_back(object.value);
  leaf.apart = view.apart;
  if constexpr (D == 2) {
    HWY_DYNAMIC_DISPATCH(keep_2)(view, leaf);
  } else {
    HWY_DYNAMIC_DISPATCH(keep_3)(view, leaf);
  }
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
void add_entry(KeptLeaf<D>& leaf, std::uint32_t object, DepthMask apart,
               std::span<const PackedBox<D>> boxes) {
  make_room(leaf, leaf.objects.size() + 1, true);
  if constexpr (D == 2) {
    HWY_DYNAMIC_DISPATCH(add_2)(leaf, object, apart, boxes.data());
  } else {
    HWY_DYNAMIC_DISPATCH(add_3)(leaf, object, apart, boxes.data());
  }
}

template <int D>
void filter_rows(std::span<const std::uint32_t> rows, std::span<const PackedBox<D>> boxes,
                 PairBuffer& pairs) {
  if constexpr (D == 2) {
    HWY_DYNAMIC_DISPATCH(filter_2)(rows, boxes.data(), pairs);
  } else {
    HWY_DYNAMIC_DISPATCH(filter_3)(rows, boxes.data(), pairs);
  }
}

#define KERF_INSTANTIATE(D)                                                                          \
  template void keep_entries<D>(const LeafView<D>&, KeptLeaf<D>&);                                   \
  template void drop_entry<D>(KeptLeaf<D>&, std::size_t);                                            \
  template void add_entry<D>(KeptLeaf<D>&, std::uint32_t, DepthMask, std::span<const PackedBox<D>>); \
  template void filter_rows<D>(std::span<const std::uint32_t>, std::span<const PackedBox<D>>, PairBuffer&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
#endif
