#include "frames/rivals/rival_base.h"

#include "frames/rivals/step_timer.h"

namespace kerf {

template <int D>
RivalBase<D>::RivalBase(const RivalHints<D>& hints, Intake intake) : intake_(intake) {
  shown_.reserve(hints.capacity);
  fixed_.reserve(hints.capacity);
  held_.reserve(hints.capacity);
}

/// Updates the library to the last request.
template <int D>
void RivalBase<D>::show(ObjectId object, const Box<D>& given) {
  const bool raw = intake_ == Intake::raw;
  if (shown_.size() <= object.index()) {
    shown_.resize(object.index() + 1);
    fixed_.resize(object.index() + 1);
    held_.resize(object.index() + 1);
  }
  std::uint8_t& held = held_[object.index()];
  if (!raw && !table_.is_placed(object)) {
    if (held != 0) drop(object);
    held = 0;
    return;
  }
  const Box<D>& box = shown_[object.index()] = raw ? given : table_.box(object);
  fixed_[object.index()] = table_.is_fixed(object) ? 1 : 0;
  if (held != 0) {
    change(object, box);
  } else {
    add(object, box, is_fixed(object));
  }
  held = 1;
}

template <int D>
Status RivalBase<D>::insert(ObjectId object, const Box<D>& box, Mobility mobility) {
  const Status status = table_.insert(object, box, mobility);
  if (!is_refused(status)) show(object, box);
  return status;
}

template <int D>
Status RivalBase<D>::move(ObjectId object, const Box<D>& box) {
  const Status status = table_.move(object, box);
  if (status != Status::unknown_id) show(object, box);
  return status;
}

template <int D>
Status RivalBase<D>::remove(ObjectId object) {
  const Status status = table_.remove(object);
  if (status == Status::ok && held_[object.index()] != 0) {
    drop(object);
    held_[object.index()] = 0;
  }
  return status;
}

template <int D>
void RivalBase<D>::step() {
  pairs_.clear();
  candidates_.clear();
  find_pairs();
  guaranteed_ = pairs_.size();
  left_ = candidates_.size();
  complete();
}

template <int D>
void RivalBase<D>::complete() {
  collect_pairs();
  for (const auto& [a, b] : candidates_)
    if (overlaps(shown(a), shown(b))) report(a, b);
}

template <int D>
std::uint64_t RivalBase<D>::time_added() {
  pairs_.resize(guaranteed_);
  candidates_.resize(left_);
  const StepTimer timer(true);
  complete();
  return timer.nanoseconds();
}

template class RivalBase<2>;
template class RivalBase<3>;

}  // namespace kerf
