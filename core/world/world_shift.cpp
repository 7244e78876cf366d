#include <cmath>
#include <vector>

#include "core/world/world.h"

namespace kerf {

template <int D>
WorldStatus World<D>::shift_origin(const Vector<D>& by) {
  for (const Scalar along : by.value)
    if (!std::isfinite(along)) return WorldStatus::bad_value;
  std::vector<Handle> objects;
  std::vector<Box<D>> boxes;
  for_each([&](Handle object) {
    const Box<D> box = exact_box({object.index()});
    objects.push_back(object);
    boxes.push_back({box.min + by, box.max + by});
  });
  return move(objects, boxes);
}

template WorldStatus World<2>::shift_origin(const Vector<2>&);
template WorldStatus World<3>::shift_origin(const Vector<3>&);

}  // namespace kerf
