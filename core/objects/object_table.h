#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/base/task_pool.h"
#include "core/geometry/box.h"
#include "core/geometry/packed_box.h"
#include "core/geometry/volume.h"
#include "core/objects/status.h"

namespace kerf {

/// The state of an id.
enum class ObjectState : std::uint8_t { absent, placed, quarantined };

/// What is kept per object is an array as long as the largest id. So that memory depends on the number of
/// objects and not on their ids, an id beyond these many, and four more for each object present, is refused.
inline constexpr std::size_t kFreeIds = std::size_t{1} << 22U;

/// The boxes of all objects by id, with the rules for values that cannot be placed (HARD_CASES.md V1 to V3).
/// Every broad phase of ours keeps one, so that all of them answer bad requests alike.
template <int D>
class ObjectTable {
 public:
  explicit ObjectTable(VolumeKind kind = VolumeKind::box) : kind_(kind) {}

  /// `Bound` is Box<D> or Volume<D>. A bound of another kind is replaced by the smallest of the table's kind
  /// around its box.
  template <class Bound>
  Status insert(ObjectId object, const Bound& bound, Mobility mobility) {
    const Status status = admit(object, mobility);
    return status == Status::ok ? accept(object, bound) : status;
  }
  template <class Bound>
  Status move(ObjectId object, const Bound& bound) {
    return state(object) == ObjectState::absent ? Status::unknown_id : accept(object, bound);
  }
  Status remove(ObjectId object);
  /// Makes room for all ids below `bound`: none of them is too far beyond the number of objects any more.
  void make_room(std::size_t bound);
  /// Replaces the box of a placed object by one around it.
  void widen(ObjectId object, const Box<D>& box) { boxes_[object.index()] = PackedBox<D>(box); }

  /// Copies everything that another table of the same kind has of an object.
  void copy(const ObjectTable& from, ObjectId object);
  /// Copies everything except the boxes of objects that this table has already.
  void copy_but_boxes(const ObjectTable& from, TaskPool& pool);
  /// Copies everything.
  void copy_all(const ObjectTable& from, TaskPool& pool);
  /// Copies the boxes of a table with the same objects.
  void copy_boxes(const ObjectTable& from, TaskPool& pool);

  /// One more than the largest id ever used: the size for arrays kept per object.
  [[nodiscard]] std::size_t bound() const { return boxes_.size(); }
  /// Objects present, those in quarantine included.
  [[nodiscard]] std::uint32_t size() const { return size_; }
  [[nodiscard]] ObjectState state(ObjectId object) const {
    return object.index() < states_.size() ? states_[object.index()] : ObjectState::absent;
  }
  [[nodiscard]] bool is_placed(ObjectId object) const { return state(object) == ObjectState::placed; }
  [[nodiscard]] bool is_fixed(ObjectId object) const { return fixed_[object.index()] != 0; }
  /// Whether any object has ever been fixed.
  [[nodiscard]] bool has_fixed() const { return has_fixed_; }
  [[nodiscard]] VolumeKind kind() const { return kind_; }
  /// The box as it was accepted. Valid for placed objects only.
  [[nodiscard]] Box<D> box(ObjectId object) const { return boxes_[object.index()].unpack(); }
  [[nodiscard]] const PackedBox<D>& packed(ObjectId object) const { return boxes_[object.index()]; }
  /// By id, `bound()` of them; undefined for objects that are not placed.
  [[nodiscard]] std::span<const PackedBox<D>> packed() const { return boxes_; }
  /// For code that replaces boxes of placed objects by valid ones, many at a time.
  [[nodiscard]] std::span<PackedBox<D>> packed() { return boxes_; }
  /// The numbers that the kind stores beside the box, `extra_size<D>(kind())` of them.
  [[nodiscard]] const Scalar* extra(ObjectId object) const {
    return extra_.data() + object.index() * static_cast<std::size_t>(extra_size<D>(kind_));
  }
  /// Box and numbers together.
  [[nodiscard]] Volume<D> volume(ObjectId object) const;
  /// Whether two placed objects are a pair: the definition, for the tree and for the oracle.
  [[nodiscard]] bool is_pair(ObjectId a, ObjectId b) const {
    return overlaps(packed(a), packed(b)) && !(is_fixed(a) && is_fixed(b)) &&
           volumes_overlap<D>(kind_, extra(a), extra(b));
  }

 private:
  Status admit(ObjectId object, Mobility mobility);
  [[nodiscard]] bool is_sparse(ObjectId object) const {
    return object.index() >= states_.size() && object.index() >= kFreeIds + 4 * std::size_t{size_};
  }
  Status accept(ObjectId object, const Box<D>& box);
  Status accept(ObjectId object, const Volume<D>& given);

  VolumeKind kind_;
  std::vector<PackedBox<D>> boxes_;
  std::vector<Scalar> extra_;
  std::vector<ObjectState> states_;
  std::vector<std::uint8_t> fixed_;
  bool has_fixed_ = false;
  std::uint32_t size_ = 0;
};

/// Calls `work(object)` for each placed object, in the order of the ids.
template <int D, class Work>
void for_each_placed(const ObjectTable<D>& table, Work work) {
  for (std::uint32_t id = 0; id < table.bound(); ++id)
    if (table.is_placed({id})) work(ObjectId{id});
}

}  // namespace kerf
