#pragma once

#include <fcl/broadphase/broadphase_collision_manager.h>

#include <vector>

#include "core/geometry/box.h"

namespace kerf {

/// Rounded outward where FCL computes in doubles.
template <typename S>
Box<3> to_box(const fcl::AABB<S>& from) {
  Box<3> box;
  for (int i = 0; i < 3; ++i) {
    box.min[i] = round_down(static_cast<double>(from.min_[i]));
    box.max[i] = round_up(static_cast<double>(from.max_[i]));
  }
  return box;
}

template <typename S>
std::vector<fcl::CollisionObject<S>*> objects_of(const fcl::BroadPhaseCollisionManager<S>& manager) {
  std::vector<fcl::CollisionObject<S>*> objects;
  manager.getObjects(objects);
  return objects;
}

}  // namespace kerf
