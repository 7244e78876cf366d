#include "core/bsp/kept_pairs.h"

#include <algorithm>
#include <utility>

#include "core/kernels/prefetch.h"

namespace kerf {
namespace {

void drop_restless(std::vector<RestlessEntry>& entries, ObjectId object) {
  const auto it = std::ranges::find(entries, object.value, &RestlessEntry::object);
  if (it == entries.end()) return;
  *it = entries.back();
  entries.pop_back();
}

template <int D>
void push_back(LeafView<D>& view, const PackedBox<D>& box, ObjectId object, DepthMask apart) {
  view.boxes.push_back(box);
  view.objects.push_back(object);
  view.apart.push_back(apart);
}

/// Moves the restless entries of a view into the leaf's list of them.
template <int D>
void take_restless(const KeptObjects<D>& objects, LeafView<D>& view, KeptLeaf<D>& leaf) {
  std::size_t written = 0;
  for (std::size_t i = 0; i < view.size(); ++i) {
    if (objects.is_restless(view.objects[i])) {
      leaf.restless.push_back({view.objects[i].value, view.apart[i]});
      continue;
    }
    view.boxes[written] = view.boxes[i];
    view.objects[written] = view.objects[i];
    view.apart[written] = view.apart[i];
    ++written;
  }
  view.resize(written);
}

template <int D>
void view_restless(const KeptLeaf<D>& leaf, const ObjectTable<D>& table, LeafView<D>& view) {
  view.resize(0);
  for (const auto& [object, apart] : leaf.restless) push_back(view, table.packed({object}), {object}, apart);
}

/// Of the entries that come, those that are kept; the others go into the leaf's list of restless ones.
template <int D>
void view_coming(std::span<const EntryChange> changes, const ObjectTable<D>& fat, KeptLeaf<D>& leaf,
                 LeafView<D>& view) {
  view.resize(0);
  for (const EntryChange& change : changes) {
    if (!change.comes) continue;
    if (change.restless) {
      leaf.restless.push_back({change.object.value, change.apart});
    } else {
      push_back(view, fat.packed(change.object), change.object, change.apart);
    }
  }
}

void make_room(std::vector<std::uint8_t>& marks, std::size_t objects) {
  marks.resize(std::max(marks.size(), objects), 0);
}

/// Marks the leaf's objects that have fat: each has many pairs, and is looked at but once.
template <int D>
std::span<const std::uint8_t> mark_fat(const KeptObjects<D>& objects, const KeptLeaf<D>& leaf,
                                       std::vector<std::uint8_t>& marks) {
  make_room(marks, objects.fat.bound());
  for (const std::uint32_t object : leaf.objects) marks[object] = objects.has_fat({object}) ? 1 : 0;
  return marks;
}

/// Takes pairs of fat boxes, named as the leaf's candidates are. What is the first to come gets no room for
/// more: most leaves get no more.
template <int D, class HasFat>
void keep_pairs(std::span<const Pair> pairs, HasFat has_fat, KeptLeaf<D>& leaf) {
  const auto objects_of = [&leaf](const Pair& pair) {
    return leaf.names == Names::objects
               ? pair
               : Pair{{leaf.objects[pair.a.index()]}, {leaf.objects[pair.b.index()]}};
  };
  const auto stands = [&](const Pair& pair) {
    const Pair two = objects_of(pair);
    return !has_fat(two.a) && !has_fat(two.b);
  };
  if (leaf.standing.pairs.empty() && leaf.candidates.empty()) {
    const auto standing = static_cast<std::size_t>(std::ranges::count_if(pairs, stands));
    leaf.standing.pairs.reserve(standing);
    leaf.candidates.reserve(pairs.size() - standing);
  }
  for (const Pair& pair : pairs) {
    const Pair two = objects_of(pair);
    if (stands(pair)) {
      leaf.standing.push_back(make_pair(two.a, two.b));
    } else {
      leaf.candidates.push_back(two.a < two.b ? pair : Pair{pair.b, pair.a});
    }
  }
}

/// From now on an entry's object is its place.
template <int D>
void name_by_places(LeafView<D>& view) {
  for (std::uint32_t k = 0; k < view.size(); ++k) view.objects[k] = {k};
}

/// Whether of a leaf with so many restless entries nothing is kept; one that is swept goes on with fewer.
bool are_many(std::size_t restless, std::size_t entries, bool swept) {
  constexpr std::size_t kEntries = 4;
  constexpr std::size_t kSweptEntries = 6;
  return restless * (swept ? kSweptEntries : kEntries) > entries;
}

/// For the boxes that the filter will read in any order, unless it needs but a few, or gathers them itself.
/// Always inlined, for the reason why `prefetch` is.
template <int D>
HWY_INLINE void ask_for_boxes(const KeptLeaf<D>& leaf, const ObjectTable<D>& latest) {
  if (leaf.names == Names::places || leaf.candidates.size() < leaf.objects.size()) return;
  for (const std::uint32_t object : leaf.objects) prefetch(&latest.packed({object}));
}

/// Where the table is long, boxes are read from anywhere: they are asked for ahead.
template <bool Boxes, int D>
void view_leaf(const Tree<D>& tree, const ObjectTable<D>& table, NodeId leaf, LeafView<D>& view) {
  const std::vector<Entry>& entries = tree[leaf].entries;
  const bool some_fixed = table.has_fixed();
  view.objects.resize(entries.size());
  view.apart.resize(entries.size());
  if constexpr (Boxes) view.boxes.resize(entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const ObjectId object = entries[i].object;
    if constexpr (Boxes) {
      prefetch(&table.packed(entries[std::min(i + kPrefetchAhead, entries.size() - 1)].object));
      view.boxes[i] = table.packed(object);
    }
    view.objects[i] = object;
    view.apart[i] = apart_bits(tree[leaf], entries[i].straddle, some_fixed && table.is_fixed(object));
  }
}

/// Forgets all that is known of the leaf but how many restless entries it has.
template <int D>
void begin_sweeping(KeptLeaf<D>& leaf, std::size_t restless_entries) {
  KeptLeaf<D> swept;
  swept.generation = leaf.generation;
  swept.standing.place = leaf.standing.place;
  swept.standing.room = leaf.standing.room;
  leaf = std::move(swept);
  leaf.swept = true;
  leaf.restless_entries = restless_entries;
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

template <int D>
void KeptPairs<D>::clear() {
  leaves_.clear();
  changes_.clear();
  touched_.clear();
  standing_.clear();
}

template <int D>
bool KeptPairs<D>::note_restless(const Tree<D>& tree, NodeId leaf, std::size_t count) {
  if (is_known(tree, leaves_, leaf)) leaves_[leaf.index()].restless_entries = count;
  return are_many(count, tree[leaf].entries.size(), false);
}

template <int D>
void KeptPairs<D>::placed(Tree<D>& tree) {
  for (const NodeId leaf : touched_) tree[leaf].changed = false;
}

template <int D>
void KeptPairs<D>::find(Tree<D>& tree, const ObjectTable<D>& latest, const std::vector<Skin>& skins,
                        LeafPass<D>& pass, TaskPool& pool, PairBuffer& pairs) {
  leaves_.resize(std::max<std::size_t>(leaves_.size(), tree.slots()));
  changes_.resize(leaves_.size());
  const bool far = pool.threads() > 1 || exceeds(latest.packed(), kOwnCache);
  const Objects objects{tree.table, latest, skins, far};
  standing_.begin_step(tree, leaves_, pairs);
  pass.run(
      tree, pool,
      [&](NodeId leaf, LeafScratch<D>& scratch, PairBuffer& found) {
        renew(tree, objects, leaf, scratch);
        find_in(tree, objects, leaf, scratch, found);
      },
      pairs);
  standing_.end_step(tree, leaves_, pairs);
  for (const NodeId leaf : touched_) changes_[leaf.index()].clear();
  touched_.clear();
}

/// The pairs of a leaf that is up to date.
template <int D>
void KeptPairs<D>::find_in(const Tree<D>& tree, const Objects& objects, NodeId id, LeafScratch<D>& scratch,
                           PairBuffer& pairs) {
  KeptLeaf<D>& leaf = leaves_[id.index()];
  if (leaf.swept) {
    view_leaf(tree, objects.latest, id, scratch.view);
    return scratch.byte_sweep.find(scratch.view, pairs);
  }
  pairs.append(leaf.standing.others());
  if (objects.far) ask_for_boxes(leaf, objects.latest);
  filter_candidates<D>(leaf, objects.latest.packed(), scratch.gathered, pairs);
  if (leaf.restless.empty()) return;
  view_restless(leaf, objects.latest, scratch.view);
  append_entries(scratch.view, leaf);
  probe_last(leaf, scratch.view.size(), objects.latest.packed(), Names::objects, scratch.byte_sweep.found,
             pairs);
  drop_last(leaf, scratch.view.size());
}

/// Patches the leaf, unless an operator changed it or so many objects are touched that sweeping is cheaper.
/// Of one that is swept anyway nothing is to be renewed.
template <int D>
void KeptPairs<D>::renew(Tree<D>& tree, const Objects& objects, NodeId id, LeafScratch<D>& scratch) {
  constexpr std::size_t kSweepBelow = 4;  // entries a touch
  Node<D>& node = tree[id];
  const Changes changes = changes_[id.index()];
  KeptLeaf<D>& leaf = leaves_[id.index()];
  const bool known = is_known(tree, leaves_, id);
  if (known && leaf.swept && are_many(leaf.restless_entries, node.entries.size(), true)) return;
  if (!known || leaf.swept || node.changed || changes.size() * kSweepBelow > node.entries.size()) {
    sweep(tree, objects, id, scratch);
    node.changed = false;
  } else if (!changes.empty()) {
    patch(objects, changes, scratch);
  }
  if (are_many(leaf.restless.size(), node.entries.size(), false)) begin_sweeping(leaf, leaf.restless.size());
}

template <int D>
void KeptPairs<D>::patch(const Objects& objects, Changes changes, LeafScratch<D>& scratch) {
  KeptLeaf<D>& leaf = leaves_[changes.front().leaf.index()];
  drop_going(changes, objects.fat.bound(), scratch);
  view_coming(changes, objects.fat, leaf, scratch.view);
  if (scratch.view.size() == 0) return;
  append_entries(scratch.view, leaf);
  scratch.pairs.clear();
  probe_last(leaf, scratch.view.size(), objects.fat.packed(), leaf.names, scratch.byte_sweep.found,
             scratch.pairs);
  keep_pairs(
      std::as_const(scratch.pairs).all(), [&](ObjectId object) { return objects.has_fat(object); }, leaf);
}

/// A few objects are looked for one by one; for many, one pass over all pairs is cheaper. `objects`: the room
/// for marks.
template <int D>
void KeptPairs<D>::drop_going(Changes changes, std::size_t objects, LeafScratch<D>& scratch) {
  constexpr std::ptrdiff_t kFew = 16;
  KeptLeaf<D>& leaf = leaves_[changes.front().leaf.index()];
  const auto goes = [](const EntryChange& change) { return !change.comes && !change.restless; };
  if (std::ranges::count_if(changes, goes) <= kFew) {
    for (const EntryChange& change : changes)
      if (goes(change)) drop_object(leaf, change.object.value);
  } else {
    make_room(scratch.marks, objects);
    for (const EntryChange& change : changes)
      if (goes(change)) scratch.marks[change.object.index()] = 1;
    drop_marked<D>(leaf, scratch.marks);
    for (const EntryChange& change : changes) scratch.marks[change.object.index()] = 0;
  }
  for (const EntryChange& change : changes)
    if (change.restless && !change.comes) drop_restless(leaf.restless, change.object);
}

template <int D>
void KeptPairs<D>::sweep(const Tree<D>& tree, const Objects& objects, NodeId id, LeafScratch<D>& scratch) {
  KeptLeaf<D>& leaf = leaves_[id.index()];
  leaf.generation = tree[id].generation + 1;
  leaf.swept = false;
  view_leaf(tree, tree.table, id, scratch.view);
  empty_leaf(scratch.view, leaf);
  take_restless(objects, scratch.view, leaf);
  if (are_many(leaf.restless.size(), tree[id].entries.size(), false)) return;
  append_entries(scratch.view, leaf);
  scratch.pairs.clear();
  leaf.names = exceeds(objects.latest.packed(), kOwnPages) ? Names::places : Names::objects;
  if (leaf.names == Names::places) name_by_places(scratch.view);
  scratch.byte_sweep.find(scratch.view, scratch.pairs);
  const std::span<const std::uint8_t> has_fat = mark_fat(objects, leaf, scratch.marks);
  keep_pairs(
      std::as_const(scratch.pairs).all(), [&](ObjectId object) { return has_fat[object.index()] != 0; },
      leaf);
  for (const std::uint32_t object : leaf.objects) scratch.marks[object] = 0;
}

#define KERF_INSTANTIATE(D)                                                                         \
  template void view_leaf<D>(const Tree<D>&, const ObjectTable<D>&, NodeId, LeafView<D>&);          \
  template void view_all_but_boxes<D>(const Tree<D>&, const ObjectTable<D>&, NodeId, LeafView<D>&); \
  template class KeptPairs<D>;
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
