#include "core/broad_phase/tabled.h"

#include <chrono>

#include "core/base/float_mode.h"

namespace kerf {

/// The list is out of date only if the set of placed objects changes.
template <int D>
Status Tabled<D>::track(ObjectId object, Status status) {
  if (is_refused(status)) return status;
  const bool listed = object.index() < listed_.size() && listed_[object.index()] != 0;
  list_is_old_ |= listed != table_.is_placed(object);
  return status;
}

template <int D>
Status Tabled<D>::insert(ObjectId object, const Box<D>& box, Mobility mobility) {
  const DefaultFloats floats;
  return track(object, table_.insert(object, box, mobility));
}

template <int D>
Status Tabled<D>::remove(ObjectId object) {
  return track(object, table_.remove(object));
}

template <int D>
Status Tabled<D>::move_many(std::span<const ObjectId> objects, std::span<const Box<D>> boxes) {
  const DefaultFloats floats;
  Status first = Status::ok;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    const Status status = track(objects[k], table_.move(objects[k], boxes[k]));
    if (first == Status::ok) first = status;
  }
  return first;
}

template <int D>
void Tabled<D>::list_placed() {
  placed_.clear();
  listed_.assign(table_.bound(), 0);
  for_each_placed(table_, [&](ObjectId object) {
    placed_.push_back(object);
    listed_[object.index()] = 1;
  });
  list_is_old_ = false;
}

template <int D>
void Tabled<D>::step() {
  const DefaultFloats floats;
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = times_arranging_ ? Clock::now() : Clock::time_point{};
  if (list_is_old_) list_placed();
  arrange();
  if (times_arranging_) arrange_seconds_ = std::chrono::duration<double>(Clock::now() - start).count();
  pairs_.clear();
  find_pairs(pairs_);
}

template class Tabled<2>;
template class Tabled<3>;

}  // namespace kerf
