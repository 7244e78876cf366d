#include "core/objects/object_table.h"

#include <algorithm>

#include "core/base/list_room.h"

namespace kerf {
namespace {

template <class T>
void copy_vector(const std::vector<T>& from, std::vector<T>& to, TaskPool& pool) {
  to.resize(from.size());
  pool.for_slices(from.size(), [&](const Slice& slice, std::size_t) {
    std::copy_n(from.data() + slice.begin, slice.end - slice.begin, to.data() + slice.begin);
  });
}

}  // namespace

template <int D>
Status ObjectTable<D>::accept(ObjectId object, const Box<D>& box) {
  if (kind_ != VolumeKind::box || !is_valid(box)) return accept(object, make_box_volume(box));
  states_[object.index()] = ObjectState::placed;
  boxes_[object.index()] = PackedBox<D>(box);
  return Status::ok;
}

template <int D>
Status ObjectTable<D>::accept(ObjectId object, const Volume<D>& given) {
  const Volume<D> volume = given.kind == kind_ ? given : enclose(clamp_to_finite(given).box, kind_);
  if (!is_ordered(given) || !is_ordered(volume)) {
    states_[object.index()] = ObjectState::quarantined;
    return Status::quarantined;
  }
  const Volume<D> finite = clamp_to_finite(volume);
  const auto size = static_cast<std::size_t>(extra_size<D>(kind_));
  states_[object.index()] = ObjectState::placed;
  boxes_[object.index()] = PackedBox<D>(finite.box);
  std::copy_n(finite.extra.begin(), size,
              extra_.begin() + static_cast<std::ptrdiff_t>(object.index() * size));
  return finite.box == given.box && finite.extra == volume.extra ? Status::ok : Status::clamped;
}

template <int D>
void ObjectTable<D>::make_room(std::size_t bound) {
  if (bound <= states_.size()) return;
  // A copy that ended for lack of memory may have left more boxes than flags: the number of boxes never
  // falls.
  const std::size_t count = std::max(bound, boxes_.size());
  const std::size_t extras = count * static_cast<std::size_t>(extra_size<D>(kind_));
  grow_list(boxes_, count);
  grow_list(extra_, extras);
  grow_list(fixed_, count);
  grow_list(states_, count);
  boxes_.resize(count);
  extra_.resize(extras);
  fixed_.resize(count, 0);
  states_.resize(count, ObjectState::absent);
}

template <int D>
Status ObjectTable<D>::admit(ObjectId object, Mobility mobility) {
  if (object.is_none()) return Status::unknown_id;
  if (state(object) != ObjectState::absent) return Status::duplicate_id;
  if (is_sparse(object)) return Status::sparse_id;
  make_room(object.index() + 1);
  ++size_;
  fixed_[object.index()] = mobility == Mobility::fixed ? 1 : 0;
  has_fixed_ |= mobility == Mobility::fixed;
  return Status::ok;
}

template <int D>
Status ObjectTable<D>::remove(ObjectId object) {
  if (state(object) == ObjectState::absent) return Status::unknown_id;
  states_[object.index()] = ObjectState::absent;
  --size_;
  return Status::ok;
}

template <int D>
void ObjectTable<D>::copy(const ObjectTable& from, ObjectId object) {
  make_room(object.index() + 1);
  const std::size_t i = object.index();
  const auto size = static_cast<std::size_t>(extra_size<D>(kind_));
  if (states_[i] != ObjectState::absent) --size_;
  if (from.states_[i] != ObjectState::absent) ++size_;
  states_[i] = from.states_[i];
  fixed_[i] = from.fixed_[i];
  has_fixed_ |= from.has_fixed_;
  boxes_[i] = from.boxes_[i];
  std::copy_n(from.extra(object), size, extra_.data() + i * size);
}

template <int D>
void ObjectTable<D>::copy_but_boxes(const ObjectTable& from, TaskPool& pool) {
  // Tables never shrink, so the other one is at least as long.
  boxes_.insert(boxes_.end(), from.boxes_.begin() + static_cast<std::ptrdiff_t>(boxes_.size()),
                from.boxes_.end());
  copy_vector(from.extra_, extra_, pool);
  copy_vector(from.fixed_, fixed_, pool);
  copy_vector(from.states_, states_, pool);  // last, since make_room goes by it
  has_fixed_ |= from.has_fixed_;
  size_ = from.size_;
}

template <int D>
void ObjectTable<D>::copy_all(const ObjectTable& from, TaskPool& pool) {
  copy_boxes(from, pool);
  copy_but_boxes(from, pool);
}

template <int D>
void ObjectTable<D>::copy_boxes(const ObjectTable& from, TaskPool& pool) {
  copy_vector(from.boxes_, boxes_, pool);
}

template <int D>
Volume<D> ObjectTable<D>::volume(ObjectId object) const {
  Volume<D> result;
  result.kind = kind_;
  result.box = box(object);
  std::copy_n(extra(object), extra_size<D>(kind_), result.extra.begin());
  return result;
}

template class ObjectTable<2>;
template class ObjectTable<3>;

}  // namespace kerf
