#include "core/kernels/sweep.h"

namespace kerf {

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
}

template void sweep_leaf<2>(const ObjectTable<2>&, const Node<2>&, SweepBuffer<2>&, std::vector<Pair>&);
template void sweep_leaf<3>(const ObjectTable<3>&, const Node<3>&, SweepBuffer<3>&, std::vector<Pair>&);

}  // namespace kerf
