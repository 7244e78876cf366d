#include <algorithm>
#include <cmath>
#include <vector>

#include "core/world/world.h"
#include "core/world/world_boxes.h"

namespace kerf {
namespace {

template <int D>
Box<D> shifted(const Box<D>& box, const Vector<D>& by) {
  return {box.min + by, box.max + by};
}

}  // namespace

template <int D>
WorldStatus World<D>::shift_origin(const Vector<D>& by) {
  for (const Scalar along : by.value)
    if (!std::isfinite(along)) return WorldStatus::bad_value;
  if (margins_ > 0) return shift_each(by);
  std::vector<Handle> objects;
  std::vector<Box<D>> boxes;
  for_each([&](Handle object) {
    objects.push_back(object);
    boxes.push_back(shifted(tree_->objects().box({object.index()}), by));
  });
  return move(objects, boxes);
}

/// Fat boxes come along. Rounding keeps the order of numbers, so each holds its box as before.
template <int D>
WorldStatus World<D>::shift_each(const Vector<D>& by) {
  Change change(*this);
  WorldStatus sum = WorldStatus::ok;
  for_each([&](Handle object) {
    const ObjectId id{object.index()};
    Box<D> box = shifted(exact_box(id), by);
    sum = std::max(sum, clamp(box));
    (void)tree_->move(id, shifted(tree_->objects().box(id), by));
    if (defs_[id.index()].margin > 0) exact_[id.index()] = box;
  });
  unstepped_ |= size() > 0;
  change.finish();
  return sum;
}

template WorldStatus World<2>::shift_origin(const Vector<2>&);
template WorldStatus World<3>::shift_origin(const Vector<3>&);

}  // namespace kerf
