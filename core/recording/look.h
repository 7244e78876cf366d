#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/base/ids.h"
#include "core/recording/turn.h"
#include "core/scene/scene.h"
#include "core/scene/shape_kind.h"

namespace kerf {

/// The number of no shape: all that is known of such an object is its box.
inline constexpr std::uint32_t kNoShape = std::numeric_limits<std::uint32_t>::max();

/// How much a brick is larger along each of its axes than its shape says, in 512ths of that. What breathes
/// has another size in every step, and needs no shape for each.
template <int D>
using Stretch = std::array<std::int16_t, D>;

/// How an object looks: its shape, by the number that it has in the recording, and how it is turned. Where it
/// stands follows from its box (see `pose_in_box`).
template <int D>
struct Look {
  std::uint32_t shape = kNoShape;
  Turn<D> turn;
  Stretch<D> stretch{};
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

/// How an object looks to a recorder. The shape must live until its step has been recorded.
template <int D>
struct Appearance {
  const Shape<D>* shape = nullptr;  ///< null: only its box is known
  Turn<D> turn;
  std::optional<Stretch<D>> stretch{};  ///< of the shape; none: the recorder may take one for another shape
};

template <int D>
Appearance<D> appearance_of(const Look<D>& look, const std::vector<Shape<D>>& shapes) {
  return {look.shape == kNoShape ? nullptr : &shapes[look.shape], look.turn, look.stretch};
}

/// The shape with its stretch.
template <int D>
Shape<D> stretched(const Shape<D>& shape, const Stretch<D>& stretch);
/// The stretch by which `base` becomes `shape`, but for rounding. None unless both are bricks, and no extent
/// is less than 0.6 or more than 1.6 of what it was: what breaks has a new shape.
template <int D>
std::optional<Stretch<D>> stretch_between(const Shape<D>& base, const Shape<D>& shape);

/// A sphere looks alike however it is turned; a disc has a spoke.
template <int D>
Appearance<D> appearance_of(const Body<D>& body) {
  if constexpr (D == 3)
    if (is_ball<D>(body.shape)) return {&body.shape, {}, std::nullopt};
  return {&body.shape, turn_of<D>(body.pose.axes), std::nullopt};
}

}  // namespace kerf
