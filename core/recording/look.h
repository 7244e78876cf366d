#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/base/ids.h"
#include "core/recording/turn.h"
#include "core/scene/scene.h"

namespace kerf {

/// The number of no shape: all that is known of such an object is its box.
inline constexpr std::uint32_t kNoShape = std::numeric_limits<std::uint32_t>::max();

/// How an object looks: its shape, by the number that it has in the recording, and how it is turned. Where it
/// stands follows from its box (see `pose_in_box`).
template <int D>
struct Look {
  std::uint32_t shape = kNoShape;
  Turn<D> turn;
  friend bool operator==(const Look&, const Look&) = default;
};

/// Another look of an object from a step on.
template <int D>
struct LookChange {
  ObjectId object;
  Look<D> look;
  friend bool operator==(const LookChange&, const LookChange&) = default;
};

/// The looks of all objects at a moment.
template <int D>
class Looks {
 public:
  [[nodiscard]] Look<D> of(ObjectId object) const {
    return object.index() < looks_.size() ? looks_[object.index()] : Look<D>();
  }
  void set(ObjectId object, const Look<D>& look) {
    if (object.index() >= looks_.size()) looks_.resize(object.index() + 1);
    looks_[object.index()] = look;
  }
  void apply(const std::vector<LookChange<D>>& changes) {
    for (const LookChange<D>& change : changes) set(change.object, change.look);
  }
  /// No object from this number on has a shape.
  [[nodiscard]] std::uint32_t bound() const { return static_cast<std::uint32_t>(looks_.size()); }
  friend bool operator==(const Looks& a, const Looks& b) {
    const std::uint32_t bound = std::max(a.bound(), b.bound());
    for (std::uint32_t id = 0; id < bound; ++id)
      if (a.of({id}) != b.of({id})) return false;
    return true;
  }

 private:
  std::vector<Look<D>> looks_;
};

/// How an object looks to whoever records it. The shape must live until its step has been recorded.
template <int D>
struct Appearance {
  const Shape<D>* shape = nullptr;  ///< null: only its box is known
  Turn<D> turn;
};

template <int D>
Appearance<D> appearance_of(const Look<D>& look, const std::vector<Shape<D>>& shapes) {
  return {look.shape == kNoShape ? nullptr : &shapes[look.shape], look.turn};
}

/// A sphere looks alike however it is turned; a disc has a spoke.
template <int D>
Appearance<D> appearance_of(const Body<D>& body) {
  if constexpr (D == 3)
    if (std::holds_alternative<Ball>(body.shape)) return {&body.shape, {}};
  return {&body.shape, turn_of<D>(body.pose.axes)};
}

}  // namespace kerf
