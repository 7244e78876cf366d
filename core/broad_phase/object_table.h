#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/broad_phase/broad_phase.h"
#include "core/geometry/box.h"
#include "core/ids.h"

namespace kerf {

/// What is known of an id.
enum class ObjectState : std::uint8_t { absent, placed, quarantined };

/// The boxes of all objects by id, with the rules for values that cannot be placed (HARD_CASES.md V1 to V3).
/// Every broad phase of ours keeps one, so that all of them answer bad requests alike.
template <int D>
class ObjectTable {
 public:
  Status insert(ObjectId object, const Box<D>& box, Mobility mobility);
  Status move(ObjectId object, const Box<D>& box);
  Status remove(ObjectId object);

  /// One more than the largest id ever used: the size for arrays kept per object.
  [[nodiscard]] std::size_t bound() const { return boxes_.size(); }
  /// Objects present, the quarantined ones included.
  [[nodiscard]] std::uint32_t size() const { return size_; }
  [[nodiscard]] ObjectState state(ObjectId object) const {
    return object.index() < states_.size() ? states_[object.index()] : ObjectState::absent;
  }
  [[nodiscard]] bool is_placed(ObjectId object) const { return state(object) == ObjectState::placed; }
  [[nodiscard]] bool is_fixed(ObjectId object) const { return fixed_[object.index()] != 0; }
  /// The box as it was accepted. Valid for placed objects only.
  [[nodiscard]] const Box<D>& box(ObjectId object) const { return boxes_[object.index()]; }
  [[nodiscard]] std::span<const Box<D>> boxes() const { return boxes_; }

 private:
  Status accept(ObjectId object, const Box<D>& box);

  std::vector<Box<D>> boxes_;
  std::vector<ObjectState> states_;
  std::vector<std::uint8_t> fixed_;
  std::uint32_t size_ = 0;
};

extern template class ObjectTable<2>;
extern template class ObjectTable<3>;

}  // namespace kerf
