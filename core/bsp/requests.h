#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/append_buffer.h"
#include "core/base/task_pool.h"
#include "core/geometry/packed_box.h"
#include "core/objects/object_flags.h"
#include "core/objects/object_table.h"
#include "core/objects/skin.h"

namespace kerf {

/// The caller's requests since the last step: the latest boxes, and the list of changed objects, for
/// which the tree's table may differ. An object is listed once, however many requests name it.
template <int D>
class Requests {
 public:
  /// What a request needs to know of the tree.
  struct Receiver {
    ObjectTable<D>& table;  ///< of the tree
    TaskPool& pool;
    bool keeps;  ///< the table has fat boxes: an object that stays inside its own is not listed
  };

  explicit Requests(VolumeKind kind) : latest_(kind) {}

  // Of the caller.
  template <class Bound>
  Status insert(ObjectId object, const Bound& bound, Mobility mobility, const Receiver& tree) {
    return change(object, tree.keeps, [&] { return latest_.insert(object, bound, mobility); });
  }
  Status move(ObjectId object, const Volume<D>& volume, const Receiver& tree);
  Status move_many(std::span<const ObjectId> objects, std::span<const Box<D>> boxes, const Receiver& tree);
  Status remove(ObjectId object, const Receiver& tree);
  [[nodiscard]] VolumeKind kind() const { return latest_.kind(); }
  [[nodiscard]] const ObjectTable<D>& latest() const { return latest_; }

  // Of a step. The last call of each must be `finish_step`.
  [[nodiscard]] std::span<const ObjectId> changed() const { return changed_.all(); }
  /// While pairs are kept: the boxes from which the changed objects moved, in the same order; of one that
  /// came, its own.
  [[nodiscard]] std::span<const PackedBox<D>> before() const { return before_.all(); }
  [[nodiscard]] std::span<PackedBox<D>> before() { return before_.all(); }
  /// Whether more objects changed than this share of all.
  [[nodiscard]] bool changed_exceed(float share) const {
    return static_cast<float>(changed_.size()) > share * static_cast<float>(latest_.size());
  }
  /// How many requests were accepted, some of them perhaps for one object, or for its box as it was.
  [[nodiscard]] std::size_t given() const { return given_; }
  /// Whether nothing was requested but that placed objects go to valid boxes.
  [[nodiscard]] bool are_moves() const { return only_moves_; }
  [[nodiscard]] std::span<ObjectFlags> flags() { return flags_; }
  [[nodiscard]] std::span<const ObjectFlags> flags() const { return flags_; }
  /// Lists an object, with these flags, of which nothing was requested.
  void list_unasked(ObjectId object, ObjectFlags flags, const PackedBox<D>& before);
  /// Takes those off the list that have no flag any more.
  void forget_unchanged();
  /// Room for the moves of so many objects in one call: it then allocates nothing.
  void make_room_for_moves(std::size_t count);
  /// There are flags for all objects from now on.
  void make_room() { flags_.resize(latest_.bound(), flag::kUnplaced); }
  /// The flags of an object of which nothing is pending. `skins`: of all objects while pairs are kept, else
  /// none.
  [[nodiscard]] ObjectFlags flags_at_rest(ObjectId object, std::span<const Skin> skins) const {
    if (!latest_.is_placed(object)) return flag::kUnplaced;
    return !skins.empty() && skins[object.index()].is_restless() ? flag::kUnrequested : ObjectFlags{0};
  }
  /// All requests are met.
  void finish_step(std::span<const Skin> skins, TaskPool& pool);
  /// No moves are taken without a request from now on.
  void end_following();

  /// Nothing is requested of these objects.
  void restore(const ObjectTable<D>& latest, std::span<const Skin> skins);

 private:
  template <class Change>
  Status change(ObjectId object, bool keeps, Change change);
  void move_some(std::span<const ObjectId> objects, std::span<const Box<D>> boxes, std::size_t begin,
                 const Receiver& tree);
  Status move_left_over(std::span<const ObjectId> objects, std::span<const Box<D>> boxes, bool keeps);
  void settle(std::span<const Skin> skins, TaskPool& pool);

  ObjectTable<D> latest_;           ///< as the caller sees the objects; boxes of the tree's follow in a step
  std::vector<ObjectFlags> flags_;  ///< by object
  AppendBuffer<ObjectId> changed_;
  AppendBuffer<PackedBox<D>> before_;
  AppendBuffer<std::uint32_t> left_over_;  ///< of one call of `move_many`
  std::size_t given_ = 0;
  bool only_moves_ = true;
};

/// Asks the table of the latest boxes for a change, and lists the object unless it is refused.
template <int D>
template <class Change>
Status Requests<D>::change(ObjectId object, bool keeps, Change change) {
  const bool was_placed = latest_.is_placed(object);
  const PackedBox<D> before = was_placed ? latest_.packed(object) : PackedBox<D>{};
  const Status status = change();
  if (is_refused(status)) return status;
  ++given_;
  only_moves_ = false;
  make_room();
  ObjectFlags& flags = flags_[object.index()];
  if ((flags & flag::kChanged) != 0) return status;
  flags |= flag::kChanged;
  changed_.push_back(object);
  if (keeps) before_.push_back(was_placed ? before : latest_.packed(object));
  return status;
}

}  // namespace kerf
