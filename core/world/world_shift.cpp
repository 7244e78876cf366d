#include <cmath>
#include <vector>

#include "core/base/float_mode.h"
#include "core/world/world.h"
#include "core/world/world_boxes.h"

namespace kerf {

/// Fat boxes come along. Rounding keeps the order of numbers, so each holds its box as before. All memory is
/// there before an object moves.
template <int D>
WorldStatus World<D>::shift_origin(const Vector<D>& by) {
  if (is_asking_) return WorldStatus::busy;
  for (const Scalar along : by.value)
    if (!std::isfinite(along)) return WorldStatus::bad_value;
  const DefaultFloats floats;
  fat_boxes_.clear();
  fat_boxes_.reserve(size());
  ids_.clear();
  ids_.reserve(size());
  bool in_range = true;
  for_each([&](Handle object) {
    const ObjectId id{object.index()};
    ids_.push_back(id);
    const Box<D> box = tree_->objects().box(id);
    Box<D>& fat = fat_boxes_.emplace_back();  // written in place: to copy it would wait for single floats
    for (int axis = 0; axis < D; ++axis) {
      fat.min[axis] = box.min[axis] + by[axis];
      fat.max[axis] = box.max[axis] + by[axis];
    }
    if (margins_ == 0) {
      in_range &= is_valid(fat);
    } else {
      in_range &= is_valid(shifted(exact_box(id), by));
    }
  });
  move_listed();
  if (margins_ > 0) {
    for (const ObjectId id : ids_) {
      if (!is_thick(defs_[id.index()].margin)) continue;
      exact_[id.index()] = shifted(exact_[id.index()], by);
      (void)clamp(exact_[id.index()]);
    }
  }
  return in_range ? WorldStatus::ok : WorldStatus::clamped;
}

template WorldStatus World<2>::shift_origin(const Vector<2>&);
template WorldStatus World<3>::shift_origin(const Vector<3>&);

}  // namespace kerf
