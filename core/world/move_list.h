#pragma once

#include <vector>

#include "core/geometry/box.h"
#include "core/world/handle.h"
#include "core/world/world.h"

namespace kerf {

/// Moves that are gathered one by one and made all at once, which is what a World is fast at.
template <int D>
class MoveList {
 public:
  void add(Handle object, const Box<D>& box) {
    objects_.resize(boxes_.size());  // memory may have ended between the two
    objects_.push_back(object);
    boxes_.push_back(box);
  }
  /// Makes all moves that were added since the last call, in that order. Those that fail, of a removed object
  /// or to a box that is none, change nothing. Returns the first failure, as World::move does; all moves are
  /// kept for the next call if the world is busy.
  WorldStatus send(World<D>& world) {
    objects_.resize(boxes_.size());
    const WorldStatus status = world.move(objects_, boxes_);
    if (status == WorldStatus::busy) return status;
    objects_.clear();
    boxes_.clear();
    return status;
  }

 private:
  std::vector<Handle> objects_;
  std::vector<Box<D>> boxes_;
};

}  // namespace kerf
