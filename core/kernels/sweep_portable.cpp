#include <algorithm>

#include "core/kernels/sweep.h"

namespace kerf {
namespace {

/// Takes out the pairs from `begin` on whose boxes overlap but whose volumes do not.
template <int D>
void drop_separated(const ObjectTable<D>& table, std::size_t begin, std::vector<Pair>& pairs) {
  const auto separated = [&](const Pair& pair) {
    return !volumes_overlap<D>(table.kind(), table.extra(pair.a), table.extra(pair.b));
  };
  pairs.erase(std::remove_if(pairs.begin() + static_cast<std::ptrdiff_t>(begin), pairs.end(), separated),
              pairs.end());
}

}  // namespace

template <int D>
void sweep_leaf(const ObjectTable<D>& table, const Node<D>& leaf, SweepBuffer<D>& buffer,
                std::vector<Pair>& pairs) {
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

template void sweep_leaf<2>(const ObjectTable<2>&, const Node<2>&, SweepBuffer<2>&, std::vector<Pair>&);
template void sweep_leaf<3>(const ObjectTable<3>&, const Node<3>&, SweepBuffer<3>&, std::vector<Pair>&);

}  // namespace kerf
