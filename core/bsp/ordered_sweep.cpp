#include "core/bsp/ordered_sweep.h"

#include <algorithm>

namespace kerf {
template <int D>
void drop_separated(const ObjectTable<D>& table, std::size_t begin, PairBuffer& pairs) {
  const std::span<Pair> found = pairs.all().subspan(begin);
  const auto end = std::remove_if(found.begin(), found.end(), [&](const Pair& pair) {
    return !volumes_overlap<D>(table.kind(), table.extra(pair.a), table.extra(pair.b));
  });
  pairs.truncate(begin + static_cast<std::size_t>(end - found.begin()));
}

template <int D>
void sweep_leaf(const ObjectTable<D>& table, const Node<D>& leaf, SweepBuffer<D>& buffer, PairBuffer& pairs) {
  const std::vector<Entry>& entries = leaf.entries;
  buffer.boxes.resize(entries.size());
  buffer.fixed.resize(entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    buffer.boxes[i] = table.box(entries[i].object);
    buffer.fixed[i] = table.is_fixed(entries[i].object) ? 1 : 0;
  }
  const std::size_t begin = pairs.size();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Entry& a = entries[i];
    const Box<D> box = buffer.boxes[i];
    const DepthMask elsewhere = a.straddle & leaf.right_of;
    for (std::size_t j = i + 1; j < entries.size() && entries[j].key.lo <= a.key.hi; ++j) {
      if (!overlaps(box, buffer.boxes[j])) continue;
      if ((elsewhere & entries[j].straddle) == 0 && (buffer.fixed[i] & buffer.fixed[j]) == 0)
        pairs.push_back(make_pair(a.object, entries[j].object));
    }
  }
  if (table.kind() != VolumeKind::box) drop_separated(table, begin, pairs);
}

template void drop_separated<2>(const ObjectTable<2>&, std::size_t, PairBuffer&);
template void drop_separated<3>(const ObjectTable<3>&, std::size_t, PairBuffer&);
template void sweep_leaf<2>(const ObjectTable<2>&, const Node<2>&, SweepBuffer<2>&, PairBuffer&);
template void sweep_leaf<3>(const ObjectTable<3>&, const Node<3>&, SweepBuffer<3>&, PairBuffer&);

}  // namespace kerf
