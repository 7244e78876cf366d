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
  changes_.clear();
  leaves_.clear();
}

template <int D>
void KeptPairs<D>::placed(Tree<D>& tree) {
  for (const EntryChange& change : changes_) tree[change.leaf].changed = false;
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
  std::stable_sort(changes_.begin(), changes_.end(),
                   [](const EntryChange& a, const EntryChange& b) { return a.leaf < b.leaf; });
  for (std::size_t begin = 0; begin < changes_.size();) {
    std::size_t end = begin;
    while (end < changes_.size() && changes_[end].leaf == changes_[begin].leaf) ++end;
    Node<D>& node = tree[changes_[begin].leaf];
    if ((end - begin) * kSweepBelow > node.entries.size()) node.changed = true;
    if (node.alive && !node.changed) patch(tree, std::span(changes_).subspan(begin, end - begin));
    begin = end;
  }
  changes_.clear();
}

/// A few objects are looked for one by one; for many, one pass over all pairs is cheaper.
template <int D>
void KeptPairs<D>::patch(const Tree<D>& tree, std::span<const EntryChange> changes) {
  constexpr std::size_t kFew = 16;
  KeptLeaf<D>& leaf = leaves_[changes.front().leaf.index()];
  if (changes.size() <= kFew) {
    for (const EntryChange& change : changes) drop_object(leaf, change.object.value);
  } else {
    for (const EntryChange& change : changes) marks_[change.object.index()] = 1;
    drop_marked(leaf);
    for (const EntryChange& change : changes) marks_[change.object.index()] = 0;
  }
  for (const EntryChange& change : changes)
    if (change.present) add_entry(leaf, change.object.value, change.apart, tree.table.packed());
}

/// Takes the marked objects out of the entries and out of all pairs.
template <int D>
void KeptPairs<D>::drop_marked(KeptLeaf<D>& leaf) {
  for (std::size_t k = leaf.objects.size(); k > 0; --k)
    if (marks_[leaf.objects[k - 1]] != 0) drop_entry(leaf, k - 1);
  std::size_t written = 0;
  for (const Pair& pair : leaf.pairs) {
    leaf.pairs[written] = pair;
    written += (marks_[pair.a.index()] | marks_[pair.b.index()]) == 0 ? 1 : 0;
  }
  leaf.pairs.resize(written);
}

template <int D>
void KeptPairs<D>::sweep(const Tree<D>& tree, NodeId id) {
  KeptLeaf<D>& leaf = leaves_[id.index()];
  leaf.generation = tree[id].generation + 1;
  view_leaf(tree, id, view_);
  keep_entries(view_, leaf);
  found_.clear();
  byte_sweep_.find(view_, found_);
  leaf.pairs.assign(found_.all().begin(), found_.all().end());
}

template <int D>
void KeptPairs<D>::emit(const Tree<D>& tree, const ObjectTable<D>& table, PairBuffer& pairs) const {
  for_each_node(tree, tree.root(), [&](NodeId id) {
    if (tree[id].is_leaf()) filter_pairs<D>(leaves_[id.index()].pairs, table.packed(), pairs);
  });
}

#define KERF_INSTANTIATE(D)                                         \
  template void view_leaf<D>(const Tree<D>&, NodeId, LeafView<D>&); \
  template class KeptPairs<D>;
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
