// How the tree places fat boxes while pairs are kept (DESIGN.md, "Fast").

#include <algorithm>

#include "core/bsp/bsp.h"
#include "core/objects/skin.h"
#include "core/tree/placement.h"

namespace kerf {

template <int D, class Trace>
Box<D> Bsp<D, Trace>::fat_box(ObjectId object, const Box<D>& before, bool had_fat) {
  Skin& skin = skins_[object.index()];
  if ((attention_[object.index()] & kAtRest) != 0) return latest_.box(object);
  if ((attention_[object.index()] & kSlimmed) != 0) {
    skin.wrap(step_);
    return wrap(latest_.box(object), skin);
  }
  skin.left(step_, had_fat);
  skin.moved(is_fast(latest_.box(object), before));
  if (skin.is_restless()) return latest_.box(object);
  return fatten(latest_.box(object), before, skin, config_.skin, fat_share(object.value));
}

/// Fat boxes for all, by the motion since the tree's boxes.
template <int D, class Trace>
void Bsp<D, Trace>::fatten_all() {
  skins_.resize(latest_.bound());
  attention_.resize(latest_.bound(), kUnplaced);
  pool_->for_slices(latest_.bound(), [this](const Slice& slice, std::size_t) {
    for (std::size_t id = slice.begin; id < slice.end; ++id) {
      const ObjectId object{static_cast<std::uint32_t>(id)};
      if (!latest_.is_placed(object)) continue;
      skins_[id].restless = 0;  // what it was before leaves were swept
      const bool known = tree_.table.is_placed(object);
      const Box<D> fat = fat_box(object, known ? tree_.table.box(object) : latest_.box(object), false);
      if (id < tree_.table.bound()) tree_.table.widen(object, fat);
      attention_[id] = attention_at_rest(object);
    }
  });
  tree_.table.copy_but_boxes(latest_, *pool_);
  place_all();
}

/// Looks at some objects in each step, at all of them in 64: who did not move since the last look loses its
/// fat, so that its pairs with others at rest stand; who stays in the fat box of a flight is wrapped in its
/// skin instead. The candidates of both are filtered in each step.
template <int D, class Trace>
void Bsp<D, Trace>::slim_some() {
  const auto bound = static_cast<std::uint32_t>(std::min(skins_.size(), attention_.size()));
  const Slice some = slice(bound, Skin::kLook, step_ % Skin::kLook);
  for (std::size_t id = some.begin; id < some.end; ++id) {
    const ObjectId object{static_cast<std::uint32_t>(id)};
    const PackedBox<D>& box = latest_.packed(object);
    if (attention_[id] != 0 || tree_.table.packed(object).lane == box.lane) continue;
    if (skins_[id].is_unmoved(fingerprint(box))) {
      note_unasked(object, kChanging | kAtRest, box);
    } else if (skins_[id].is_at_rest(step_) && is_for_flight(tree_.table.box(object), latest_.box(object))) {
      note_unasked(object, kChanging | kSlimmed, box);
    }
  }
}

/// Has an object placed anew of which nobody asked that.
template <int D, class Trace>
void Bsp<D, Trace>::note_unasked(ObjectId object, std::uint8_t attention, const PackedBox<D>& before) {
  attention_[object.index()] = attention;
  changed_.push_back(object);
  before_.push_back(before);
}

/// Restless objects are followed; who calmed or went into other leaves is treated as if it had left its fat
/// box.
template <int D, class Trace>
void Bsp<D, Trace>::follow_restless() {
  restless_pass_.run(tree_, {latest_, skins_, attention_, kSilent}, kept_, *pool_);
  for (const ObjectId object : restless_pass_.others())
    note_unasked(object, kChanging | kSilent, tree_.table.packed(object));
  keep_or_sweep_.kept_at(restless_pass_.cost());
}

/// The new fat boxes of those that left theirs, into fat_.
template <int D, class Trace>
void Bsp<D, Trace>::make_fat_boxes() {
  skins_.resize(latest_.bound());
  fat_.resize(changed_.size());
  pool_->for_slices(changed_.size(), [this](const Slice& slice, std::size_t) {
    for (std::size_t k = slice.begin; k < slice.end; ++k) {
      const ObjectId object = changed_.all()[k];
      Skin& skin = skins_[object.index()];
      if (!tree_.table.is_placed(object)) skin.restless = 0;  // what it was in an earlier life
      if (skin.is_restless()) attention_[object.index()] |= kWasRestless;
      if (latest_.is_placed(object)) {
        const PackedBox<D>& before = before_.all()[k];
        const bool had_fat = tree_.table.is_placed(object) && tree_.table.packed(object).lane != before.lane;
        fat_[k] = fat_box(object, before.unpack(), had_fat);
      } else {
        skin.restless = 0;
      }
    }
  });
}

template <int D, class Trace>
void Bsp<D, Trace>::take_fat_boxes() {
  for (std::size_t k = 0; k < changed_.size(); ++k) {
    const ObjectId object = changed_.all()[k];
    tree_.table.copy(latest_, object);
    if (latest_.is_placed(object)) tree_.table.widen(object, fat_[k]);
  }
}

/// Each object that left its fat box gets another one, and its kept pairs are looked up again.
template <int D, class Trace>
void Bsp<D, Trace>::place_fat() {
  make_fat_boxes();
  const auto find_places = [this](const Slice& slice, std::size_t k) {
    fat_pieces_[k].clear();
    for (std::size_t at = slice.begin; at < slice.end; ++at) find_fat_places(at, fat_pieces_[k]);
  };
  fat_pieces_.resize(pool_->slices_of(changed_.size(), TaskPool::kFewWalks));
  pool_->for_slices(changed_.size(), find_places, TaskPool::kFewWalks);
  take_out();
  take_fat_boxes();
  placed_ = 0;
  for (const FatPiece& piece : fat_pieces_) put_in(piece);
  kept_.placed(tree_);
}

template <int D, class Trace>
void Bsp<D, Trace>::take_out() {
  std::vector<Departure> departures;
  for (const FatPiece& piece : fat_pieces_) {
    for (const EntryChange& change : piece.entries) kept_.note(change);
    for (const NodeId leaf : piece.touched) tree_[leaf].unsorted = true;
    for (const ObjectId object : piece.leaving)
      if (!latest_.is_placed(object)) reporter_.report([&] { return ObjectPlaced{object, 0}; });
    departures.push_back({piece.leaving, piece.left});
  }
  displace<D>(tree_, departures, *pool_);
}

template <int D, class Trace>
void Bsp<D, Trace>::put_in(const FatPiece& piece) {
  for (const NodeId node : piece.entered) ++tree_[node].population;
  std::size_t next = 0;
  for (const Arrival& arrival : piece.entering) {
    for (const std::size_t end = next + arrival.leaves; next < end; ++next)
      tree_.add_entry(piece.places[next].leaf, arrival.object, piece.places[next].straddle);
    reporter_.report([&] { return ObjectPlaced{arrival.object, arrival.leaves}; });
  }
  placed_ += piece.entering.size();
}

/// The entries that an object loses and gets, in leaves that keep pairs.
template <int D, class Trace>
void Bsp<D, Trace>::note_entries(ObjectId object, FatPiece& piece) const {
  for (const auto& [leaf, straddle] : piece.old_places)
    if (kept_.keeps(tree_, leaf)) piece.entries.push_back({leaf, object, 0, false, was_restless(object)});
  const bool is_restless = skins_[object.index()].is_restless();
  for (const auto& [leaf, straddle] : piece.new_places)
    if (kept_.keeps(tree_, leaf))
      piece.entries.push_back(
          {leaf, object, apart_bits(tree_[leaf], straddle, latest_.is_fixed(object)), true, is_restless});
}

/// Where the k-th of the changed objects was, and where it goes.
template <int D, class Trace>
void Bsp<D, Trace>::find_fat_places(std::size_t k, FatPiece& piece) const {
  const ObjectId object = changed_.all()[k];
  const bool was_placed = tree_.table.is_placed(object);
  const bool is_placed = latest_.is_placed(object);
  const std::size_t left = piece.left.size();
  const std::size_t entered = piece.entered.size();
  piece.old_places.clear();
  piece.new_places.clear();
  if (was_placed) reach(tree_, tree_.table.box(object), piece.old_places, piece.left);
  if (is_placed) reach(tree_, fat_[k], piece.new_places, piece.entered);
  note_entries(object, piece);
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

#define KERF_INSTANTIATE(D, TRACE)                                                        \
  template Box<D> Bsp<D, TRACE>::fat_box(ObjectId, const Box<D>&, bool);                  \
  template void Bsp<D, TRACE>::fatten_all();                                              \
  template void Bsp<D, TRACE>::slim_some();                                               \
  template void Bsp<D, TRACE>::note_unasked(ObjectId, std::uint8_t, const PackedBox<D>&); \
  template void Bsp<D, TRACE>::follow_restless();                                         \
  template void Bsp<D, TRACE>::make_fat_boxes();                                          \
  template void Bsp<D, TRACE>::take_fat_boxes();                                          \
  template void Bsp<D, TRACE>::place_fat();                                               \
  template void Bsp<D, TRACE>::take_out();                                                \
  template void Bsp<D, TRACE>::put_in(const FatPiece&);                                   \
  template void Bsp<D, TRACE>::note_entries(ObjectId, FatPiece&) const;                   \
  template void Bsp<D, TRACE>::find_fat_places(std::size_t, FatPiece&) const;
KERF_FOR_EACH_TRACE(KERF_INSTANTIATE)
#undef KERF_INSTANTIATE

}  // namespace kerf
