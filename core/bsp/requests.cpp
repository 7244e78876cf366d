#include "core/bsp/requests.h"

#include <algorithm>
#include <utility>

#include "core/base/float_mode.h"
#include "core/base/tuning.h"
#include "core/kernels/move_boxes.h"

namespace kerf {

template <int D>
Status Requests<D>::move(ObjectId object, const Volume<D>& volume, const Receiver& tree) {
  if (kind() == VolumeKind::box && volume.kind == VolumeKind::box)
    return move_many({&object, 1}, {&volume.box, 1}, tree);
  return change(object, tree.keeps, [&] { return latest_.move(object, volume); });
}

template <int D>
Status Requests<D>::remove(ObjectId object, const Receiver& tree) {
  return change(object, tree.keeps, [&] { return latest_.remove(object); });
}

template <int D>
Status Requests<D>::move_many(std::span<const ObjectId> objects, std::span<const Box<D>> boxes,
                              const Receiver& tree) {
  if (kind() != VolumeKind::box) {
    const DefaultFloats floats;
    Status first = Status::ok;
    for (std::size_t k = 0; k < objects.size(); ++k) {
      const Status status =
          change(objects[k], tree.keeps, [&] { return latest_.move(objects[k], boxes[k]); });
      if (first == Status::ok) first = status;
    }
    return first;
  }
  left_over_.clear();  // of a call that ended for lack of memory, before a state was restored
  const std::size_t piece = tree.keeps && tree.pool.threads() == 1 ? tuning::kFewThings : objects.size();
  for (std::size_t begin = 0; begin < objects.size(); begin += piece) {
    const std::size_t count = std::min(piece, objects.size() - begin);
    move_some(objects.subspan(begin, count), boxes.subspan(begin, count), begin, tree);
  }
  given_ += objects.size() - left_over_.size();
  return move_left_over(objects, boxes, tree.keeps);
}

template <int D>
void Requests<D>::make_room_for_moves(std::size_t count) {
  (void)changed_.reserve(count);
  (void)before_.reserve(count);
  (void)left_over_.reserve(count);
}

/// A part of a call: the kernel needs room for the changes of all its objects, and while pairs are kept few
/// change. `begin`: the place of the first in the call.
template <int D>
void Requests<D>::move_some(std::span<const ObjectId> objects, std::span<const Box<D>> boxes,
                            std::size_t begin, const Receiver& tree) {
  ObjectId* const changed = changed_.reserve(objects.size());
  PackedBox<D>* const before = tree.keeps ? before_.reserve(objects.size()) : nullptr;
  std::uint32_t* const left_over = left_over_.reserve(objects.size());
  const MoveAnswer answer = move_boxes<D>(
      {objects, boxes, latest_.packed(), flags_,
       tree.keeps ? std::as_const(tree.table).packed().data() : nullptr, changed, before, left_over},
      tree.pool);
  changed_.commit(answer.changed);
  if (tree.keeps) before_.commit(answer.changed);
  for (std::size_t k = 0; k < answer.left_over; ++k) left_over[k] += static_cast<std::uint32_t>(begin);
  left_over_.commit(answer.left_over);
}

/// Moves what the kernel left over, one by one: an object that moves again, too. Returns the first status
/// that is not ok.
template <int D>
Status Requests<D>::move_left_over(std::span<const ObjectId> objects, std::span<const Box<D>> boxes,
                                   bool keeps) {
  Status first = Status::ok;
  for (const std::uint32_t k : left_over_.all()) {
    if (objects[k].index() < flags_.size())
      flags_[objects[k].index()] &= static_cast<ObjectFlags>(~flag::kDeferred);
    const bool only_moves = only_moves_;
    const bool was_placed = latest_.is_placed(objects[k]);
    const Status status = change(objects[k], keeps, [&] { return latest_.move(objects[k], boxes[k]); });
    if (was_placed && latest_.is_placed(objects[k])) only_moves_ = only_moves;
    if (first == Status::ok) first = status;
  }
  left_over_.clear();
  return first;
}

template <int D>
void Requests<D>::list_unasked(ObjectId object, ObjectFlags flags, const PackedBox<D>& before) {
  flags_[object.index()] = flags;
  changed_.push_back(object);
  before_.push_back(before);
}

template <int D>
void Requests<D>::forget_unchanged() {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < changed_.size(); ++k) {
    const ObjectId object = changed_.all()[k];
    if (flags_[object.index()] == 0) continue;
    changed_.all()[kept] = object;
    before_.all()[kept++] = before_.all()[k];
  }
  changed_.truncate(kept);
  before_.truncate(kept);
}

template <int D>
void Requests<D>::finish_step(std::span<const Skin> skins, TaskPool& pool) {
  settle(skins, pool);
  if (changed_.size() < tuning::kFewThings || skins.empty()) {
    changed_.clear();
    before_.clear();
  } else {  // while pairs are kept, many seldom change
    changed_ = {};
    before_ = {};
  }
  given_ = 0;
  only_moves_ = true;
}

/// Nothing is pending any more of the objects that changed.
template <int D>
void Requests<D>::settle(std::span<const Skin> skins, TaskPool& pool) {
  if (changed_.size() == 0) return;
  const bool all_alike = only_moves_ && skins.empty();
  if (all_alike && changed_.size() == flags_.size()) {
    std::ranges::fill(flags_, ObjectFlags{0});
    return;
  }
  pool.for_slices(changed_.size(), [this, all_alike, skins](const Slice& slice, std::size_t) {
    ObjectFlags* const flags = flags_.data();  // what is written through it could be this very object
    const auto objects = changed().subspan(slice.begin, slice.end - slice.begin);
    if (all_alike) {
      for (const ObjectId object : objects) flags[object.index()] = 0;
    } else {
      for (const ObjectId object : objects) flags[object.index()] = flags_at_rest(object, skins);
    }
  });
}

template <int D>
void Requests<D>::end_following() {
  for (ObjectFlags& flags : flags_) flags &= static_cast<ObjectFlags>(~flag::kUnrequested);
}

template <int D>
void Requests<D>::restore(const ObjectTable<D>& latest, std::span<const Skin> skins) {
  latest_ = latest;
  changed_.clear();
  before_.clear();
  given_ = 0;
  only_moves_ = true;
  flags_.resize(latest_.bound());
  for (std::uint32_t id = 0; id < latest_.bound(); ++id) flags_[id] = flags_at_rest({id}, skins);
}

template class Requests<2>;
template class Requests<3>;

}  // namespace kerf
