// How the tree places fat boxes while pairs are kept (DESIGN.md, "Fast").

#include <algorithm>

#include "core/broad_phase/bsp.h"
#include "core/broad_phase/skin.h"
#include "core/tree/placement.h"

namespace kerf {

template <int D, class Trace>
Box<D> Bsp<D, Trace>::fat_box(ObjectId object, const Box<D>& before) {
  Skin& skin = skins_[object.index()];
  if ((attention_[object.index()] & kSlimmed) != 0) {
    skin.wrap(step_);
    return wrap(latest_.box(object), skin);
  }
  skin.left(step_);
  skin.moved(is_fast(latest_.box(object), before));
  if (skin.is_restless()) return latest_.box(object);
  return fatten(latest_.box(object), before, skin, config_.skin, fat_share(object.value));
}

/// Fat boxes for all, by the motion since the tree's boxes.
template <int D, class Trace>
void Bsp<D, Trace>::fatten_all() {
  skins_.resize(latest_.bound());
  fat_.resize(latest_.bound());
  const auto for_placed = [this](auto work) {
    pool_->for_slices(latest_.bound(), [&](const Slice& slice, std::size_t) {
      for (std::size_t id = slice.begin; id < slice.end; ++id)
        if (latest_.is_placed({static_cast<std::uint32_t>(id)}))
          work(ObjectId{static_cast<std::uint32_t>(id)});
    });
  };
  for_placed([this](ObjectId object) {
    const bool known = tree_.table.is_placed(object);
    fat_[object.index()] = fat_box(object, known ? tree_.table.box(object) : latest_.box(object));
  });
  tree_.table.copy_all(latest_, *pool_);
  for_placed([this](ObjectId object) { tree_.table.widen(object, fat_[object.index()]); });
  list_restless();
  place_all();
}

template <int D, class Trace>
void Bsp<D, Trace>::list_restless() {
  restless_.clear();
  for (std::uint32_t id = 0; id < skins_.size(); ++id)
    if (skins_[id].is_restless() && latest_.is_placed({id})) restless_.push_back({id});
}

/// Looks at some objects in each step, at all of them in 1,024: who stays in the fat box of a flight is
/// wrapped in its skin instead, since its candidates are filtered in each step.
template <int D, class Trace>
void Bsp<D, Trace>::slim_some() {
  const auto bound = static_cast<std::uint32_t>(std::min(skins_.size(), attention_.size()));
  const Slice some = slice(bound, Skin::kRest, step_ % Skin::kRest);
  for (std::size_t id = some.begin; id < some.end; ++id) {
    const ObjectId object{static_cast<std::uint32_t>(id)};
    if (attention_[id] != 0 || !skins_[id].is_at_rest(step_)) continue;
    if (!is_for_flight(tree_.table.box(object), latest_.box(object))) continue;
    note_still(object, kChanging | kSlimmed);
  }
}

/// Has an object placed anew that nobody moved.
template <int D, class Trace>
void Bsp<D, Trace>::note_still(ObjectId object, std::uint8_t attention) {
  attention_[object.index()] = attention;
  changed_.push_back(object);
  before_.push_back(latest_.packed(object));
}

/// Who was restless and stands still gets its pairs kept again: it is treated as if it had left its fat box.
template <int D, class Trace>
void Bsp<D, Trace>::calm_some() {
  std::vector<ObjectId> calmed;
  std::erase_if(restless_, [this, &calmed](ObjectId object) {
    Skin& skin = skins_[object.index()];
    if (!skin.is_restless()) return true;
    if (attention_[object.index()] != 0 || !skin.has_calmed(step_)) return false;
    skin.calm();
    calmed.push_back(object);
    return false;
  });
  std::ranges::sort(calmed);  // the order of restless_ depends on what it went through
  for (const ObjectId object : calmed) note_still(object, kChanging);
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
        fat_[k] = fat_box(object, before_.all()[k].unpack());
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
    if (skins_[object.index()].is_restless() && !was_restless(object)) restless_.push_back(object);
  }
}

/// Each object that left its fat box gets another one, and its kept pairs are looked up again.
template <int D, class Trace>
void Bsp<D, Trace>::place_fat() {
  make_fat_boxes();
  fat_pieces_.resize(pool_->slices_of(changed_.size()));
  pool_->for_slices(changed_.size(), [this](const Slice& slice, std::size_t k) {
    fat_pieces_[k].clear();
    for (std::size_t at = slice.begin; at < slice.end; ++at) find_fat_places(at, fat_pieces_[k]);
  });
  for (const FatPiece& piece : fat_pieces_) {
    for (const EntryChange& change : piece.entries) {
      if (change.comes) tree_[change.leaf].unsorted = true;
      kept_.note(change);
    }
    for (const NodeId leaf : piece.touched) tree_[leaf].unsorted = true;
    for (const ObjectId object : piece.leaving)
      if (!latest_.is_placed(object)) reporter_.report([&] { return ObjectPlaced{object, 0}; });
  }
  for (const FatPiece& piece : fat_pieces_) displace<D>(tree_, tree_.root(), piece.leaving);
  take_fat_boxes();
  placed_ = 0;
  for (const FatPiece& piece : fat_pieces_) place_entering(piece.entering);
  kept_.placed(tree_);
}

/// Whether the k-th of the changed objects was restless, is it still and stays what and in the leaves where
/// it was: nothing is kept of it, so nothing must be renewed. If so, notes the leaves.
template <int D, class Trace>
bool Bsp<D, Trace>::stays_restless(std::size_t k, std::vector<NodeId>& leaves) const {
  const ObjectId object = changed_.all()[k];
  return was_restless(object) && skins_[object.index()].is_restless() && latest_.is_placed(object) &&
         tree_.table.is_fixed(object) == latest_.is_fixed(object) &&
         reach_alike(tree_, tree_.table.box(object), fat_[k], leaves);
}

/// Where the k-th of the changed objects was, and where it goes.
template <int D, class Trace>
void Bsp<D, Trace>::find_fat_places(std::size_t k, FatPiece& piece) const {
  const ObjectId object = changed_.all()[k];
  const bool was_placed = tree_.table.is_placed(object);
  const bool is_placed = latest_.is_placed(object);
  if (stays_restless(k, piece.touched)) return;
  piece.old_places.clear();
  piece.new_places.clear();
  if (was_placed) reach(tree_, tree_.table.box(object), piece.old_places);
  if (is_placed) reach(tree_, fat_[k], piece.new_places);
  for (const Reached& place : piece.old_places)
    piece.entries.push_back({place.leaf, object, 0, false, was_restless(object)});
  for (const Reached& place : piece.new_places)
    piece.entries.push_back({place.leaf, object,
                             apart_bits(tree_[place.leaf], place.straddle, latest_.is_fixed(object)), true,
                             skins_[object.index()].is_restless()});
  if (piece.old_places == piece.new_places) return;
  if (was_placed) piece.leaving.push_back(object);
  if (is_placed) piece.entering.push_back(object);
}

#define KERF_INSTANTIATE(D, TRACE)                                                      \
  template Box<D> Bsp<D, TRACE>::fat_box(ObjectId, const Box<D>&);                      \
  template void Bsp<D, TRACE>::fatten_all();                                            \
  template void Bsp<D, TRACE>::list_restless();                                         \
  template void Bsp<D, TRACE>::slim_some();                                             \
  template void Bsp<D, TRACE>::note_still(ObjectId, std::uint8_t);                      \
  template void Bsp<D, TRACE>::calm_some();                                             \
  template void Bsp<D, TRACE>::make_fat_boxes();                                        \
  template void Bsp<D, TRACE>::take_fat_boxes();                                        \
  template void Bsp<D, TRACE>::place_fat();                                             \
  template bool Bsp<D, TRACE>::stays_restless(std::size_t, std::vector<NodeId>&) const; \
  template void Bsp<D, TRACE>::find_fat_places(std::size_t, Bsp<D, TRACE>::FatPiece&) const;
KERF_INSTANTIATE(2, NoTrace)
KERF_INSTANTIATE(3, NoTrace)
KERF_INSTANTIATE(2, EventLog)
KERF_INSTANTIATE(3, EventLog)
KERF_INSTANTIATE(2, Watch)
KERF_INSTANTIATE(3, Watch)
#undef KERF_INSTANTIATE

}  // namespace kerf
