#include <cmath>
#include <vector>

#include "core/world/world.h"
#include "core/world/world_boxes.h"

namespace kerf {

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

template WorldStatus World<2>::shift_origin(const Vector<2>&);
template WorldStatus World<3>::shift_origin(const Vector<3>&);

}  // namespace kerf
