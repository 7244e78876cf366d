#include "core/broad_phase/object_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kerf {
namespace {

template <int D>
bool is_ordered(const Box<D>& box) {
  bool all = true;
  for (int i = 0; i < D; ++i) all &= box.min[i] <= box.max[i];  // false for NaN
  return all;
}

Scalar clamp_to_finite(Scalar x) {
  return std::clamp(x, std::numeric_limits<Scalar>::lowest(), std::numeric_limits<Scalar>::max());
}

template <int D>
Box<D> clamp_to_finite(Box<D> box) {
  for (int i = 0; i < D; ++i) {
    box.min[i] = clamp_to_finite(box.min[i]);
    box.max[i] = clamp_to_finite(box.max[i]);
  }
  return box;
}

}  // namespace

template <int D>
Status ObjectTable<D>::accept(ObjectId object, const Box<D>& box) {
  if (!is_ordered(box)) {
    states_[object.index()] = ObjectState::quarantined;
    return Status::quarantined;
  }
  states_[object.index()] = ObjectState::placed;
  boxes_[object.index()] = clamp_to_finite(box);
  return boxes_[object.index()] == box ? Status::ok : Status::clamped;
}

template <int D>
Status ObjectTable<D>::insert(ObjectId object, const Box<D>& box, Mobility mobility) {
  if (object.is_none()) return Status::unknown_id;
  if (state(object) != ObjectState::absent) return Status::duplicate_id;
  if (object.index() >= states_.size()) {
    boxes_.resize(object.index() + 1);
    states_.resize(object.index() + 1, ObjectState::absent);
    fixed_.resize(object.index() + 1, 0);
  }
  ++size_;
  fixed_[object.index()] = mobility == Mobility::fixed ? 1 : 0;
  return accept(object, box);
}

template <int D>
Status ObjectTable<D>::move(ObjectId object, const Box<D>& box) {
  return state(object) == ObjectState::absent ? Status::unknown_id : accept(object, box);
}

template <int D>
Status ObjectTable<D>::remove(ObjectId object) {
  if (state(object) == ObjectState::absent) return Status::unknown_id;
  states_[object.index()] = ObjectState::absent;
  --size_;
  return Status::ok;
}

template class ObjectTable<2>;
template class ObjectTable<3>;

}  // namespace kerf
