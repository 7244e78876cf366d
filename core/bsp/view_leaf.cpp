#include "core/bsp/view_leaf.h"

#include <algorithm>

#include "core/base/list_room.h"
#include "core/base/tuning.h"
#include "core/kernels/prefetch.h"

namespace kerf {
namespace {

/// In a long table the boxes lie anywhere: they are prefetched.
template <bool Boxes, int D>
void view_leaf(const Tree<D>& tree, const ObjectTable<D>& table, NodeId leaf, LeafView<D>& view) {
  const std::vector<Entry>& entries = tree[leaf].entries;
  const bool some_fixed = table.has_fixed();
  resize_list(view.objects, entries.size());
  resize_list(view.apart, entries.size());
  if constexpr (Boxes) resize_list(view.boxes, entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const ObjectId object = entries[i].object;
    if constexpr (Boxes) {
      prefetch(&table.packed(entries[std::min(i + tuning::kPrefetchAhead, entries.size() - 1)].object));
      view.boxes[i] = table.packed(object);
    }
    view.objects[i] = object;
    view.apart[i] = apart_bits(tree[leaf], entries[i].straddle, some_fixed && table.is_fixed(object));
  }
}

}  // namespace

template <int D>
void view_leaf(const Tree<D>& tree, const ObjectTable<D>& table, NodeId leaf, LeafView<D>& view) {
  view_leaf<true>(tree, table, leaf, view);
}

template <int D>
void view_all_but_boxes(const Tree<D>& tree, const ObjectTable<D>& table, NodeId leaf, LeafView<D>& view) {
  view_leaf<false>(tree, table, leaf, view);
}

#define KERF_INSTANTIATE(D)                                                                \
  template void view_leaf<D>(const Tree<D>&, const ObjectTable<D>&, NodeId, LeafView<D>&); \
  template void view_all_but_boxes<D>(const Tree<D>&, const ObjectTable<D>&, NodeId, LeafView<D>&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
