#include "core/bsp/kept_step.h"

#include <algorithm>
#include <utility>

#include "core/base/tuning.h"
#include "core/bsp/leaf_boxes.h"
#include "core/bsp/place_boxes.h"
#include "core/bsp/view_leaf.h"
#include "core/kernels/prefetch.h"
#include "core/tree/placement.h"

namespace kerf {

template <int D>
template <class Trace>
std::uint64_t KeptStep<D>::place(const StepContext<D>& step, bool begins, Reporter<Trace>& reporter) {
  cost_ = 0;
  if (begins) {
    const bool many_stay = may_stay(step);
    fatten_all(step);
    return place_all(step, many_stay, reporter);
  }
  list_sleepers(step);
  if (step.shift) {
    if (!shift_pass_.run(step)) {
      kept_.clear();
      return place(step, true, reporter);
    }
    kept_.shift(*step.shift, shift_pass_.drift(), shift_pass_.slack());
  }
  follow_restless(step);
  fatten_changed(step);
  if (!step.requests.changed_exceed(tuning::kStreamFactorIfKept * step.config.stream_share))
    return place_changed(step, reporter);
  const bool many_stay = may_stay(step);
  take_fat_boxes(step);
  return place_all(step, many_stay, reporter);
}

/// The fat box of an object that left its own, or has none yet, or was listed by `list_sleepers`.
template <int D>
Box<D> KeptStep<D>::make_fat_box(const StepContext<D>& step, ObjectId object, const Box<D>& before,
                                 bool had_fat) {
  const Box<D> box = step.requests.latest().box(object);
  const ObjectFlags flags = step.requests.flags()[object.index()];
  Skin& skin = skins_[object.index()];
  if ((flags & flag::kAtRest) != 0) return box;
  if ((flags & flag::kWrapAnew) != 0) {
    skin.wrap(step.number);
    return wrap(box, skin);
  }
  skin.left(step.number, had_fat);
  skin.moved(step.config.restless && size_and_speed(box, before).is_fast());
  if (skin.is_restless()) return box;
  return fatten(box, before, skin, step.config.skin, fat_share(object.value));
}

/// Gives fat boxes to all objects, by their motions since the tree's boxes: if a shift could not be followed,
/// by the way from their old fat boxes.
template <int D>
void KeptStep<D>::fatten_all(const StepContext<D>& step) {
  const ObjectTable<D>& latest = step.requests.latest();
  ObjectTable<D>& table = step.tree.table;
  skins_.resize(latest.bound());
  step.requests.make_room();
  step.pool().for_slices(latest.bound(), [&](const Slice& slice, std::size_t) {
    const std::span<ObjectFlags> flags = step.requests.flags();
    for (std::size_t id = slice.begin; id < slice.end; ++id) {
      const ObjectId object{static_cast<std::uint32_t>(id)};
      if (!latest.is_placed(object)) continue;
      skins_[id].restless = 0;  // from before leaves were swept
      const Box<D> before = table.is_placed(object) ? table.box(object) : latest.box(object);
      const Box<D> fat = make_fat_box(step, object, before, false);
      if (id < table.bound()) table.widen(object, fat);
      flags[id] = step.requests.flags_at_rest(object, skins_);
    }
  });
  table.copy_but_boxes(latest, step.pool());
}

/// Lists objects as changed that were not moved, for two reasons. An object that did not move since the last
/// look loses its fat, so that its pairs with others at rest need no test; and an object that stays in the
/// fat box of a flight gets its skin instead. The candidates of both are filtered in each step. A step looks
/// at some of the objects, so that all are looked at in turn.
template <int D>
void KeptStep<D>::list_sleepers(const StepContext<D>& step) {
  const ObjectTable<D>& latest = step.requests.latest();
  const ObjectTable<D>& fat = step.tree.table;
  const std::span<const ObjectFlags> flags = std::as_const(step.requests).flags();
  const auto bound = static_cast<std::uint32_t>(std::min(skins_.size(), flags.size()));
  const Slice some = slice(bound, tuning::kLookSteps, step.number % tuning::kLookSteps);
  for (std::size_t id = some.begin; id < some.end; ++id) {
    const ObjectId object{static_cast<std::uint32_t>(id)};
    const PackedBox<D>& box = latest.packed(object);
    if (flags[id] != 0 || is_same(fat.packed(object), box)) continue;
    Skin& skin = skins_[id];
    const std::uint16_t seen = fingerprint(box);
    if (skin.is_unmoved(seen)) {
      step.requests.list_unasked(object, flag::kChanged | flag::kAtRest, box);
    } else if (skin.is_at_rest(step.number) && is_for_flight(fat.box(object), latest.box(object))) {
      step.requests.list_unasked(object, flag::kChanged | flag::kWrapAnew, box);
    }
    skin.look(seen);
  }
}

/// Restless objects are followed; one that calmed or went into other leaves is treated as if it had left its
/// fat box.
template <int D>
void KeptStep<D>::follow_restless(const StepContext<D>& step) {
  restless_pass_.run(step.tree, {step.requests.latest(), skins_, std::as_const(step.requests).flags()}, kept_,
                     step.pool());
  for (const ObjectId object : restless_pass_.others())
    step.requests.list_unasked(object, flag::kChanged | flag::kUnrequested, step.tree.table.packed(object));
  cost_ = restless_pass_.cost();
}

/// The new fat boxes of the objects that left theirs, into fat_.
template <int D>
void KeptStep<D>::fatten_changed(const StepContext<D>& step) {
  const ObjectTable<D>& latest = step.requests.latest();
  const ObjectTable<D>& table = step.tree.table;
  const std::span<const ObjectId> changed = step.requests.changed();
  skins_.resize(latest.bound());
  fat_.resize(changed.size());
  step.pool().for_slices(changed.size(), [&](const Slice& slice, std::size_t) {
    const std::span<ObjectFlags> flags = step.requests.flags();
    for (std::size_t k = slice.begin; k < slice.end; ++k) {
      const ObjectId object = changed[k];
      const PackedBox<D>& before = step.requests.before()[k];
      if (flags[object.index()] == flag::kMisplaced) {  // and has the right box
        fat_[k] = table.packed(object);
        continue;
      }
      Skin& skin = skins_[object.index()];
      if (!table.is_placed(object)) skin.restless = 0;  // from an earlier life
      if (skin.is_restless()) flags[object.index()] |= flag::kWasRestless;
      if (latest.is_placed(object)) {
        const bool had_fat = table.is_placed(object) && !is_same(table.packed(object), before);
        fat_[k] = PackedBox<D>(make_fat_box(step, object, before.unpack(), had_fat));
      } else {
        skin.restless = 0;
      }
    }
  });
}

template <int D>
void KeptStep<D>::take_fat_boxes(const StepContext<D>& step) const {
  const std::span<const ObjectId> changed = step.requests.changed();
  const ObjectTable<D>& latest = step.requests.latest();
  ObjectTable<D>& table = step.tree.table;
  if (!step.requests.are_moves())
    for (const ObjectId object : changed) table.copy(latest, object);
  step.pool().for_slices(changed.size(), [&](const Slice& slice, std::size_t) {
    for (std::size_t k = slice.begin; k < slice.end; ++k)
      if (latest.is_placed(changed[k])) table.packed()[changed[k].index()] = fat_[k];
  });
}

/// Places all fat boxes in one pass.
template <int D>
template <class Trace>
std::uint64_t KeptStep<D>::place_all(const StepContext<D>& step, bool many_stay,
                                     Reporter<Trace>& reporter) const {
  LeafBoxes<D> none;
  place_boxes(step, many_stay, none);
  step.memory.stream_memory = {};  // as long as the list of all objects, and seldom needed
  reporter.report([&] { return AllPlaced{step.tree.objects()}; });
  return step.requests.changed().size();
}

/// Places the new fat boxes object by object; the kept pairs of each are looked up again.
template <int D>
template <class Trace>
std::uint64_t KeptStep<D>::place_changed(const StepContext<D>& step, Reporter<Trace>& reporter) {
  const std::size_t count = step.requests.changed().size();
  pieces_.resize(step.pool().slices_of(count, tuning::kFewWalks));
  const auto find_all = [&](const Slice& slice, std::size_t k) {
    pieces_[k].clear();
    for (std::size_t at = slice.begin; at < slice.end; ++at) list_changes(step, at, pieces_[k]);
  };
  step.pool().for_slices(count, find_all, tuning::kFewWalks);
  take_out(step, reporter);
  take_fat_boxes(step);
  std::uint64_t placed = 0;
  for (const FatPiece& piece : pieces_) {
    put_in(step.tree, piece, reporter);
    placed += piece.entering.size();
  }
  kept_.placed(step.tree);
  return placed;
}

/// What changes in the tree with the k-th of the changed objects: the leaves where it was and where it goes.
template <int D>
void KeptStep<D>::list_changes(const StepContext<D>& step, std::size_t k, FatPiece& piece) const {
  const ObjectId object = step.requests.changed()[k];
  const Tree<D>& tree = step.tree;
  const bool was_placed = tree.table.is_placed(object);
  const bool is_placed = step.requests.latest().is_placed(object);
  const std::size_t left = piece.left.size();
  const std::size_t entered = piece.entered.size();
  piece.old_places.clear();
  piece.new_places.clear();
  if ((step.requests.flags()[object.index()] & flag::kMisplaced) != 0) {
    shift_pass_.append_places(object, piece.old_places, piece.left);
  } else if (was_placed) {
    reach(tree, tree.table.box(object), piece.old_places, piece.left);
  }
  if (is_placed) reach(tree, fat_[k].unpack(), piece.new_places, piece.entered);
  list_entry_changes(step, object, piece);
  if (piece.old_places == piece.new_places) {
    for (const Reached& place : piece.new_places) piece.touched.push_back(place.leaf);
    piece.left.resize(left);
    piece.entered.resize(entered);
    return;
  }
  if (was_placed) piece.leaving.push_back(object);
  if (!is_placed) return;
  piece.entering.push_back({object, static_cast<std::uint32_t>(piece.new_places.size())});
  piece.places.insert(piece.places.end(), piece.new_places.begin(), piece.new_places.end());
}

/// The entries that an object loses and gets, in leaves that keep pairs.
template <int D>
void KeptStep<D>::list_entry_changes(const StepContext<D>& step, ObjectId object, FatPiece& piece) const {
  const Tree<D>& tree = step.tree;
  const bool was_restless = (step.requests.flags()[object.index()] & flag::kWasRestless) != 0;
  const bool is_restless = skins_[object.index()].is_restless();
  for (const auto& [leaf, straddle] : piece.old_places)
    if (kept_.keeps(tree, leaf)) piece.entries.push_back({leaf, object, 0, false, was_restless});
  for (const auto& [leaf, straddle] : piece.new_places)
    if (kept_.keeps(tree, leaf))
      piece.entries.push_back({leaf, object,
                               apart_bits(tree[leaf], straddle, step.requests.latest().is_fixed(object)),
                               true, is_restless});
}

template <int D>
template <class Trace>
void KeptStep<D>::take_out(const StepContext<D>& step, Reporter<Trace>& reporter) {
  std::vector<Departure> departures;
  for (const FatPiece& piece : pieces_) {
    for (const EntryChange& change : piece.entries) kept_.add_change(change);
    for (const NodeId leaf : piece.touched) step.tree[leaf].unsorted = true;
    for (const ObjectId object : piece.leaving)
      if (!step.requests.latest().is_placed(object)) reporter.report([&] { return ObjectPlaced{object, 0}; });
    if (!piece.left.empty()) departures.push_back({piece.leaving, piece.left});
  }
  if (!departures.empty()) displace<D>(step.tree, departures, step.pool());
}

template <int D>
template <class Trace>
void KeptStep<D>::put_in(Tree<D>& tree, const FatPiece& piece, Reporter<Trace>& reporter) {
  for (const NodeId node : piece.entered) ++tree[node].population;
  std::size_t next = 0;
  for (const Arrival& arrival : piece.entering) {
    for (const std::size_t end = next + arrival.leaves; next < end; ++next)
      tree.add_entry(piece.places[next].leaf, arrival.object, piece.places[next].straddle);
    reporter.report([&] { return ObjectPlaced{arrival.object, arrival.leaves}; });
  }
}

template <int D>
void KeptStep<D>::find(const StepContext<D>& step, PairBuffer& pairs) {
  const ObjectTable<D>& latest = step.requests.latest();
  const bool far = step.pool().threads() > 1 || exceeds(latest.packed(), tuning::kOwnCache);
  kept_.find(step,
             {step.tree.table, latest, std::as_const(step.requests).flags(), step.config.resting_pairs, far},
             pairs);
}

/// A damaged recording may have too few skins.
template <int D>
void KeptStep<D>::restore(const std::vector<Skin>& skins, std::size_t objects) {
  skins_ = skins;
  skins_.resize(std::max(skins_.size(), objects));
  kept_.clear();
}

#define KERF_INSTANTIATE(D, TRACE) \
  template std::uint64_t KeptStep<D>::place(const StepContext<D>&, bool, Reporter<TRACE>&);
KERF_FOR_EACH_TRACE(KERF_INSTANTIATE)
#undef KERF_INSTANTIATE
template class KeptStep<2>;
template class KeptStep<3>;

}  // namespace kerf
