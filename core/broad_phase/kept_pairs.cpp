#include "core/broad_phase/kept_pairs.h"

#include <algorithm>

#include "core/kernels/prefetch.h"

namespace kerf {
namespace {

/// Takes the marked objects out of the entries and out of all pairs.
template <int D>
void drop_marked(KeptLeaf<D>& leaf, const std::vector<std::uint8_t>& marks) {
  for (std::size_t k = leaf.objects.size(); k > 0; --k)
    if (marks[leaf.objects[k - 1]] != 0) drop_entry(leaf, k - 1);
  std::size_t written = 0;
  for (const Pair& pair : leaf.pairs) {
    leaf.pairs[written] = pair;
    written += (marks[pair.a.index()] | marks[pair.b.index()]) == 0 ? 1 : 0;
  }
  leaf.pairs.resize(written);
}

}  // namespace

template <int D>
void view_leaf(const Tree<D>& tree, NodeId leaf, LeafView<D>& view) {
  const std::vector<Entry>& entries = tree[leaf].entries;
  view.resize(entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    prefetch(&tree.table.packed(entries[std::min(i + kPrefetchAhead, entries.size() - 1)].object));
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
void KeptPairs<D>::find(Tree<D>& tree, const ObjectTable<D>& table, LeafPass<D>& pass, TaskPool& pool,
                        PairBuffer& pairs) {
  leaves_.resize(std::max<std::size_t>(leaves_.size(), tree.slots()));
  std::stable_sort(changes_.begin(), changes_.end(),
                   [](const EntryChange& a, const EntryChange& b) { return a.leaf < b.leaf; });
  pass.run(
      tree, pool,
      [&](NodeId leaf, LeafScratch<D>& scratch, PairBuffer& found) {
        renew(tree, leaf, scratch);
        filter_pairs<D>(leaves_[leaf.index()].pairs, table.packed(), found);
      },
      pairs);
  changes_.clear();
}

template <int D>
typename KeptPairs<D>::Changes KeptPairs<D>::changes_of(NodeId leaf) const {
  struct ByLeaf {
    bool operator()(const EntryChange& change, NodeId id) const { return change.leaf < id; }
    bool operator()(NodeId id, const EntryChange& change) const { return id < change.leaf; }
  };
  const auto [begin, end] = std::equal_range(changes_.begin(), changes_.end(), leaf, ByLeaf());
  return {begin, end};
}

/// Patches the leaf, unless an operator changed it or so many objects are touched that sweeping is cheaper.
template <int D>
void KeptPairs<D>::renew(Tree<D>& tree, NodeId id, LeafScratch<D>& scratch) {
  constexpr std::size_t kSweepBelow = 4;  // entries a touch
  Node<D>& node = tree[id];
  const Changes changes = changes_of(id);
  const bool known = leaves_[id.index()].generation == node.generation + 1;
  if (node.changed || !known || changes.size() * kSweepBelow > node.entries.size()) {
    sweep(tree, id, scratch);
    node.changed = false;
  } else if (!changes.empty()) {
    patch(tree, changes, scratch);
  }
}

/// A few objects are looked for one by one; for many, one pass over all pairs is cheaper.
template <int D>
void KeptPairs<D>::patch(const Tree<D>& tree, Changes changes, LeafScratch<D>& scratch) {
  constexpr std::size_t kFew = 16;
  KeptLeaf<D>& leaf = leaves_[changes.front().leaf.index()];
  if (changes.size() <= kFew) {
    for (const EntryChange& change : changes) drop_object(leaf, change.object.value);
  } else {
    scratch.marks.resize(std::max(scratch.marks.size(), tree.table.bound()), 0);
    for (const EntryChange& change : changes) scratch.marks[change.object.index()] = 1;
    drop_marked(leaf, scratch.marks);
    for (const EntryChange& change : changes) scratch.marks[change.object.index()] = 0;
  }
  for (const EntryChange& change : changes)
    if (change.present) add_entry(leaf, change.object.value, change.apart, tree.table.packed());
}

template <int D>
void KeptPairs<D>::sweep(const Tree<D>& tree, NodeId id, LeafScratch<D>& scratch) {
  KeptLeaf<D>& leaf = leaves_[id.index()];
  leaf.generation = tree[id].generation + 1;
  view_leaf(tree, id, scratch.view);
  keep_entries(scratch.view, leaf);
  scratch.found.clear();
  scratch.byte_sweep.find(scratch.view, scratch.found);
  leaf.pairs.assign(scratch.found.all().begin(), scratch.found.all().end());
}

#define KERF_INSTANTIATE(D)                                         \
  template void view_leaf<D>(const Tree<D>&, NodeId, LeafView<D>&); \
  template class KeptPairs<D>;
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
