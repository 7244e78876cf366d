#include "core/bsp/kept_pairs.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/list_room.h"
#include "core/base/tuning.h"
#include "core/bsp/view_leaf.h"
#include "core/kernels/filter_candidates.h"
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

template <int D>
PackedBox<D> widened(PackedBox<D> box, Scalar by) {
  for (Scalar& lane : box.lane) lane -= by;
  return box;
}

/// The entries that come and are kept, with the slack around them; the others go into the leaf's list of
/// restless entries.
template <int D>
void view_coming(std::span<const EntryChange> changes, const ObjectTable<D>& fat, Scalar slack,
                 KeptLeaf<D>& leaf, LeafView<D>& view) {
  view.resize(0);
  for (const EntryChange& change : changes) {
    if (!change.comes) continue;
    if (change.restless) {
      leaf.restless.push_back({change.object.value, change.apart});
    } else {
      push_back(view, widened(fat.packed(change.object), slack), change.object, change.apart);
    }
  }
}

void make_room(std::vector<std::uint8_t>& marks, std::size_t objects) {
  marks.resize(std::max(marks.size(), objects), 0);
}

/// Marks the leaf's entries whose objects have fat, by their places: each has many pairs, and is looked at
/// but once. The view has their fat boxes.
template <int D>
void mark_fat(const KeptObjects<D>& objects, const LeafView<D>& view, std::vector<std::uint8_t>& marks) {
  const std::size_t count = view.size();
  marks.assign(count, 1);
  if (!objects.keeps_resting) return;
  for (std::size_t k = 0; k < count; ++k) {
    prefetch(&objects.latest.packed(view.objects[std::min(k + tuning::kPrefetchAhead, count - 1)]));
    marks[k] = is_same(view.boxes[k], objects.latest.packed(view.objects[k])) ? 0 : 1;
  }
}

/// Where to write the pairs of an empty list, and one more in vain. A list of none gets no memory.
Pair* begin_list(std::vector<Pair>& list, std::size_t count, Pair& nowhere) {
  if (count == 0) return &nowhere;
  list.resize(count + 1);
  return list.data();
}

/// Takes those pairs of objects without fat out of the buffer whose boxes do not overlap: they were found
/// because of the slack. `has_fat` and `id_of` are asked about names.
template <int D, class HasFat, class IdOf>
void take_near(PairBuffer& pairs, const KeptObjects<D>& objects, HasFat has_fat, IdOf id_of,
               std::vector<Pair>& near) {
  std::size_t written = 0;
  for (const Pair pair : std::as_const(pairs).all()) {
    const Pair two = make_pair(id_of(pair.a), id_of(pair.b));
    if (has_fat(pair.a) || has_fat(pair.b) ||
        overlaps(objects.fat.packed(two.a), objects.fat.packed(two.b))) {
      pairs.all()[written++] = pair;
    } else {
      near.push_back(two);
    }
  }
  pairs.truncate(written);
}

/// Takes the first pairs of fat boxes of a leaf, named by places. They get no room for more, since most
/// leaves get no more. No branch depends on a pair.
template <int D>
void keep_first_pairs(std::span<const Pair> pairs, std::span<const std::uint8_t> has_fat, KeptLeaf<D>& leaf) {
  const auto has = [marks = has_fat.data()](const Pair& pair) {
    return std::size_t{marks[pair.a.index()]} | std::size_t{marks[pair.b.index()]};
  };
  std::size_t fat = 0;
  for (const Pair& pair : pairs) fat += has(pair);
  Pair nowhere{};
  Pair* const to_resting = begin_list(leaf.resting.pairs, pairs.size() - fat, nowhere);
  Pair* const to_candidates = begin_list(leaf.candidates, fat, nowhere);
  std::size_t resting = 0;
  std::size_t candidates = 0;
  const std::uint32_t* const ids = leaf.objects.data();
  const bool by_objects = leaf.names == Names::objects;
  for (const Pair& pair : pairs) {
    const ObjectId a{ids[pair.a.index()]};
    const ObjectId b{ids[pair.b.index()]};
    const Pair two = make_pair(a, b);
    const Pair places = a < b ? pair : Pair{pair.b, pair.a};
    to_resting[resting] = two;
    to_candidates[candidates] = by_objects ? two : places;
    resting += 1 - has(pair);
    candidates += has(pair);
  }
  leaf.candidates.resize(candidates);
  leaf.resting.pairs.resize(resting);
  leaf.resting.all_changed();
}

/// Takes further pairs of fat boxes, named as the leaf's candidates are, of a few objects: either list may
/// get all of them.
template <int D>
void keep_pairs(std::span<const Pair> pairs, const KeptObjects<D>& objects, KeptLeaf<D>& leaf) {
  grow_list(leaf.resting.pairs, leaf.resting.pairs.size() + pairs.size());
  grow_list(leaf.candidates, leaf.candidates.size() + pairs.size());
  for (const Pair& pair : pairs) {
    const Pair two = leaf.names == Names::objects
                         ? pair
                         : Pair{{leaf.objects[pair.a.index()]}, {leaf.objects[pair.b.index()]}};
    if (objects.has_fat(two.a) || objects.has_fat(two.b)) {
      leaf.candidates.push_back(two.a < two.b ? pair : Pair{pair.b, pair.a});
    } else {
      leaf.resting.push_back(make_pair(two.a, two.b));
    }
  }
}

/// From now on an entry's object is its place.
template <int D>
void name_by_places(LeafView<D>& view) {
  for (std::uint32_t k = 0; k < view.size(); ++k) view.objects[k] = {k};
}

/// Whether a leaf with so many restless entries keeps nothing. A leaf that is swept goes on with fewer.
bool are_many(std::size_t restless, std::size_t entries, bool swept) {
  return restless * (swept ? tuning::kEntriesPerRestlessIfSwept : tuning::kEntriesPerRestless) > entries;
}

/// Prefetches the boxes that the filter will read in any order, unless it needs only a few, or gathers them
/// itself. Always inlined, for the reason why `prefetch` is.
template <int D>
HWY_INLINE void ask_for_boxes(const KeptLeaf<D>& leaf, const ObjectTable<D>& latest) {
  if (leaf.names == Names::places || leaf.candidates.size() < leaf.objects.size()) return;
  for (const std::uint32_t object : leaf.objects) prefetch(&latest.packed({object}));
}

/// Forgets all of the leaf but its number of restless entries.
template <int D>
void begin_sweeping(KeptLeaf<D>& leaf, std::size_t restless_entries) {
  KeptLeaf<D> swept;
  swept.resting.place = leaf.resting.place;
  swept.resting.room = leaf.resting.room;
  leaf = std::move(swept);
  leaf.swept = true;
  leaf.restless_entries = restless_entries;
}

}  // namespace

template <int D>
void KeptPairs<D>::clear() {
  leaves_.clear();
  changes_.clear();
  touched_.clear();
  resting_.clear();
  shift_.reset();
  drift_ = 0;
  sweep_all_ = false;
}

template <int D>
void KeptPairs<D>::shift(const Vector<D>& by, Scalar drift, Scalar slack) {
  shift_ = by;
  drift_ += drift;
  if (drift_ < slack_) return;
  sweep_all_ = true;
  slack_ = slack;
  drift_ = 0;
}

template <int D>
bool KeptPairs<D>::are_many_restless(const Tree<D>& tree, NodeId leaf, std::size_t count) const {
  return are_many(count, tree[leaf].entries.size(), false);
}

template <int D>
void KeptPairs<D>::set_restless_count(const Tree<D>& tree, NodeId leaf, std::size_t count) {
  if (leaves_.has(tree, leaf)) leaves_[leaf].restless_entries = count;
}

template <int D>
void KeptPairs<D>::placed(const Tree<D>& tree) {
  for (const NodeId leaf : touched_) leaves_.renew(tree, leaf);
}

template <int D>
void KeptPairs<D>::find(const StepContext<D>& step, const KeptObjects<D>& objects, PairBuffer& pairs) {
  const Tree<D>& tree = step.tree;
  leaves_.make_room(tree);
  changes_.resize(leaves_.size());
  resting_.begin_step(tree, leaves_, pairs);
  step.memory.leaf_pass.run(
      tree, step.pool(), step.config.dense,
      [&](NodeId leaf, LeafScratch<D>& scratch, PairBuffer& found) {
        renew(tree, objects, leaf, scratch);
        find_in(tree, objects, leaf, scratch, found);
      },
      pairs);
  resting_.end_step(tree, leaves_, pairs);
  for (const NodeId leaf : touched_) changes_[leaf.index()].clear();
  touched_.clear();
  shift_.reset();
  sweep_all_ = false;
}

/// The pairs of a leaf that is up to date.
template <int D>
void KeptPairs<D>::find_in(const Tree<D>& tree, const Objects& objects, NodeId id, LeafScratch<D>& scratch,
                           PairBuffer& pairs) {
  KeptLeaf<D>& leaf = leaves_[id];
  if (leaf.swept) {
    view_leaf(tree, objects.latest, id, scratch.view);
    return scratch.byte_sweep.find(scratch.view, pairs);
  }
  pairs.append(leaf.resting.others());
  if (objects.far) ask_for_boxes(leaf, objects.latest);
  filter_candidates<D>(leaf, objects.latest.packed(), scratch.gathered, pairs);
  if (leaf.restless.empty()) return;
  renew_bytes<D>(leaf, objects.fat.packed(), scratch.gathered);
  view_restless(leaf, objects.latest, scratch.view);
  append_entries(scratch.view, leaf);
  probe_last(leaf, scratch.view, objects.latest.packed(), Names::objects, scratch.byte_sweep.found, pairs);
  drop_last(leaf, scratch.view.size());
}

/// Patches the leaf, unless an operator changed it or so many of its entries changed that sweeping is
/// cheaper. A leaf that is swept in each step needs neither.
template <int D>
void KeptPairs<D>::renew(const Tree<D>& tree, const Objects& objects, NodeId id, LeafScratch<D>& scratch) {
  const std::size_t entries = tree[id].entries.size();
  const Changes changes = changes_[id.index()];
  KeptLeaf<D>& leaf = leaves_[id];
  if (leaves_.has(tree, id) && leaf.swept && are_many(leaf.restless_entries, entries, true)) return;
  const bool patch_pays = changes.size() * tuning::kEntriesPerPatch <= entries;
  if (sweep_all_ || leaf.swept || !leaves_.is_current(tree, id) || !patch_pays) {
    sweep(tree, objects, id, scratch);
  } else {
    if (shift_) shift_leaf(objects, leaf);
    if (!changes.empty()) patch(objects, changes, scratch);
  }
  if (are_many(leaf.restless.size(), entries, false)) begin_sweeping(leaf, leaf.restless.size());
}

/// What overlapped still does. Near pairs that touch now, by rounding, become resting pairs.
template <int D>
void KeptPairs<D>::shift_leaf(const Objects& objects, KeptLeaf<D>& leaf) const {
  move_bytes(*shift_, leaf);
  std::erase_if(leaf.near, [&](const Pair& pair) {
    const bool touch = overlaps(objects.fat.packed(pair.a), objects.fat.packed(pair.b));
    if (touch) leaf.resting.push_back(pair);
    return touch;
  });
}

template <int D>
void KeptPairs<D>::patch(const Objects& objects, Changes changes, LeafScratch<D>& scratch) {
  KeptLeaf<D>& leaf = leaves_[changes.front().leaf];
  drop_going(changes, objects.fat.bound(), scratch);
  view_coming(changes, objects.fat, slack_, leaf, scratch.view);
  if (scratch.view.size() == 0) return;
  renew_bytes<D>(leaf, objects.fat.packed(), scratch.gathered);
  append_entries(scratch.view, leaf);
  scratch.pairs.clear();
  probe_last(leaf, scratch.view, objects.fat.packed(), leaf.names, scratch.byte_sweep.found, scratch.pairs);
  if (slack_ > 0) {
    const auto id_of = [&](ObjectId name) {
      return leaf.names == Names::objects ? name : ObjectId{leaf.objects[name.index()]};
    };
    const auto has_fat = [&](ObjectId name) { return objects.has_fat(id_of(name)); };
    take_near(scratch.pairs, objects, has_fat, id_of, leaf.near);
  }
  keep_pairs(std::as_const(scratch.pairs).all(), objects, leaf);
}

/// A few objects are looked for by their numbers; for many, one pass over all pairs is cheaper. `objects`:
/// one more than the largest id.
template <int D>
void KeptPairs<D>::drop_going(Changes changes, std::size_t objects, LeafScratch<D>& scratch) {
  KeptLeaf<D>& leaf = leaves_[changes.front().leaf];
  const auto goes = [](const EntryChange& change) { return !change.comes && !change.restless; };
  if (static_cast<std::size_t>(std::ranges::count_if(changes, goes)) <= tuning::kFewDropped) {
    std::array<std::uint32_t, tuning::kFewDropped> going;
    std::size_t count = 0;
    for (const EntryChange& change : changes)
      if (goes(change)) going[count++] = change.object.value;
    drop_objects<D>(leaf, std::span(going).first(count));
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
  KeptLeaf<D>& leaf = leaves_[id];
  leaves_.renew(tree, id);
  leaf.swept = false;
  view_leaf(tree, tree.table, id, scratch.view);
  empty_leaf(scratch.view, leaf);
  take_restless(objects, scratch.view, leaf);
  if (are_many(leaf.restless.size(), tree[id].entries.size(), false)) return;
  append_entries(scratch.view, leaf);
  scratch.pairs.clear();
  leaf.names = exceeds(objects.latest.packed(), tuning::kOwnPages) ? Names::places : Names::objects;
  mark_fat(objects, scratch.view, scratch.has_fat);
  name_by_places(scratch.view);
  if (slack_ > 0)
    for (PackedBox<D>& box : scratch.view.boxes) box = widened(box, slack_ / 2);
  scratch.byte_sweep.find(scratch.view, scratch.pairs);
  if (scratch.byte_sweep.is_clumped) rank_bytes(scratch.view, leaf);
  if (slack_ > 0) {
    const auto id_of = [&](ObjectId place) { return ObjectId{leaf.objects[place.index()]}; };
    const auto has_fat = [&](ObjectId place) { return scratch.has_fat[place.index()] != 0; };
    take_near(scratch.pairs, objects, has_fat, id_of, leaf.near);
  }
  keep_first_pairs<D>(std::as_const(scratch.pairs).all(), scratch.has_fat, leaf);
}

template class KeptPairs<2>;
template class KeptPairs<3>;

}  // namespace kerf
