#include "core/broad_phase/kept_pairs.h"

#include <algorithm>

namespace kerf {

template <int D>
void view_leaf(const Tree<D>& tree, NodeId leaf, LeafView<D>& view) {
  const std::vector<Entry>& entries = tree[leaf].entries;
  view.resize(entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    view.boxes[i] = tree.table.packed(entries[i].object);
    view.objects[i] = entries[i].object;
    view.apart[i] = apart_bits(tree[leaf], entries[i].straddle, tree.table.is_fixed(entries[i].object));
  }
}

template <int D>
void KeptPairs<D>::clear() {
  touches_.clear();
  leaves_.clear();
}

template <int D>
void KeptPairs<D>::placed(Tree<D>& tree) {
  for (const Touch& touch : touches_) tree[touch.leaf].changed = false;
}

template <int D>
void KeptPairs<D>::update(Tree<D>& tree) {
  leaves_.resize(std::max<std::size_t>(leaves_.size(), tree.slots()));
  marks_.resize(std::max(marks_.size(), tree.table.bound()), 0);
  patch_leaves(tree);
  for_each_node(tree, tree.root(), [&](NodeId id) {
    Node<D>& node = tree[id];
    if (!node.is_leaf() || (!node.changed && leaves_[id.index()].generation == node.generation + 1)) return;
    sweep(tree, id);
    node.changed = false;
  });
}

/// Patches the touched leaves that no operator changed; where many objects are touched, sweeping is cheaper.
template <int D>
void KeptPairs<D>::patch_leaves(Tree<D>& tree) {
  constexpr std::size_t kSweepBelow = 4;  // entries a touch
  std::stable_sort(touches_.begin(), touches_.end(),
                   [](const Touch& a, const Touch& b) { return a.leaf < b.leaf; });
  for (std::size_t begin = 0; begin < touches_.size();) {
    std::size_t end = begin;
    while (end < touches_.size() && touches_[end].leaf == touches_[begin].leaf) ++end;
    Node<D>& node = tree[touches_[begin].leaf];
    if ((end - begin) * kSweepBelow > node.entries.size()) node.changed = true;
    if (node.alive && !node.changed) patch(tree, std::span(touches_).subspan(begin, end - begin));
    begin = end;
  }
  touches_.clear();
}

template <int D>
void KeptPairs<D>::patch(const Tree<D>& tree, std::span<const Touch> touches) {
  KeptLeaf<D>& leaf = leaves_[touches.front().leaf.index()];
  for (const Touch& touch : touches) marks_[touch.object.index()] = 1;
  drop_marked(leaf);
  for (const Touch& touch : touches) marks_[touch.object.index()] = 0;
  for (const Touch& touch : touches)
    if (touch.present) add_entry(leaf, touch.object.value, touch.apart, tree.table.packed());
}

/// Takes the marked objects out of the entries and out of all rows.
template <int D>
void KeptPairs<D>::drop_marked(KeptLeaf<D>& leaf) {
  for (std::size_t k = leaf.objects.size(); k > 0; --k)
    if (marks_[leaf.objects[k - 1]] != 0) drop_entry(leaf, k - 1);
  std::vector<std::uint32_t>& rows = leaf.rows;
  std::size_t written = 0;
  for (std::size_t row = 0; row < rows.size();) {
    const std::uint32_t owner = rows[row];
    const std::size_t end = row + 2 + rows[row + 1];
    std::size_t at = written + 2;
    for (std::size_t k = row + 2; k < end; ++k) {
      rows[at] = rows[k];
      at += marks_[rows[k]] == 0 ? 1 : 0;
    }
    row = end;
    if (marks_[owner] != 0 || at == written + 2) continue;
    rows[written] = owner;
    rows[written + 1] = static_cast<std::uint32_t>(at - written - 2);
    written = at;
  }
  rows.resize(written);
}

template <int D>
void KeptPairs<D>::sweep(const Tree<D>& tree, NodeId id) {
  KeptLeaf<D>& leaf = leaves_[id.index()];
  leaf.generation = tree[id].generation + 1;
  view_leaf(tree, id, view_);
  keep_entries(view_, leaf);
  found_.clear();
  byte_sweep_.find(view_, PairOrder::by_owner, found_);
  const std::span<const Pair> found = found_.all();
  leaf.rows.clear();
  for (std::size_t k = 0; k < found.size();) {
    const std::size_t head = leaf.rows.size();
    const ObjectId owner = found[k].a;
    leaf.rows.push_back(owner.value);
    leaf.rows.push_back(0);
    for (; k < found.size() && found[k].a == owner; ++k) leaf.rows.push_back(found[k].b.value);
    leaf.rows[head + 1] = static_cast<std::uint32_t>(leaf.rows.size() - head - 2);
  }
}

template <int D>
void KeptPairs<D>::emit(const Tree<D>& tree, const ObjectTable<D>& table, PairBuffer& pairs) const {
  for_each_node(tree, tree.root(), [&](NodeId id) {
    if (tree[id].is_leaf()) filter_rows(std::span(leaves_[id.index()].rows), table.packed(), pairs);
  });
}

#define KERF_INSTANTIATE(D)                                         \
  template void view_leaf<D>(const Tree<D>&, NodeId, LeafView<D>&); \
  template class KeptPairs<D>;
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
