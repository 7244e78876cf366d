#include "core/broad_phase/approximate.h"

#include <cmath>
#include <limits>
#include <utility>

namespace kerf {
namespace {

template <int D>
Box<D> unplaceable() {
  Box<D> box;
  for (int i = 0; i < D; ++i) box.min[i] = box.max[i] = std::numeric_limits<Scalar>::quiet_NaN();
  return box;
}

/// Doubles, since the quotient of two floats may be no float; the way back cannot leave the floats' range.
Scalar rounded(Scalar x, Scalar grid, double (*round)(double)) {
  return round_down(round(static_cast<double>(x) / static_cast<double>(grid)) * static_cast<double>(grid));
}

template <int D>
Box<D> rounded(const Box<D>& box, const Approximation& how) {
  const auto nearest = [](double x) { return std::floor(x + 0.5); };
  const auto up = [](double x) { return std::ceil(x); };
  const auto down = [](double x) { return std::floor(x); };
  Box<D> result;
  for (int i = 0; i < D; ++i) {
    result.min[i] = rounded(box.min[i], how.grid, how.shrink ? up : nearest);
    result.max[i] = rounded(box.max[i], how.grid, how.shrink ? down : nearest);
    if (result.min[i] > result.max[i])
      result.min[i] = result.max[i] = rounded(box.center()[i], how.grid, nearest);
  }
  return result;
}

template <int D>
Box<D> widened(const Box<D>& box, double margin) {
  Box<D> result;
  for (int i = 0; i < D; ++i) {
    result.min[i] = round_down(static_cast<double>(box.min[i]) - margin);
    result.max[i] = round_up(static_cast<double>(box.max[i]) + margin);
  }
  return result;
}

}  // namespace

template <int D>
Approximate<D>::Approximate(std::unique_ptr<BroadPhase<D>> inner, const Approximation& how)
    : inner_(std::move(inner)), how_(how), name_(inner_->name()), age_(0) {
  check(how);
  if (how != Approximation{}) name_ += " with " + to_string(how);
}

template <int D>
Box<D> Approximate<D>::handed_on(const Box<D>& box) const {
  const Box<D> wide = how_.margin > 0 ? widened(box, static_cast<double>(how_.margin)) : box;
  return how_.grid > 0 ? rounded(wide, how_) : wide;
}

template <int D>
Status Approximate<D>::insert(ObjectId object, const Box<D>& box, Mobility mobility) {
  const Status status = latest_.insert(object, box, mobility);
  if (is_refused(status)) return status;
  if (given_.size() < latest_.bound()) {
    given_.resize(latest_.bound());
    is_changed_.resize(latest_.bound(), 0);
  }
  given_[object.index()] = latest_.is_placed(object) ? handed_on(latest_.box(object)) : unplaceable<D>();
  static_cast<void>(inner_->insert(object, given_[object.index()], mobility));
  return status;
}

template <int D>
Status Approximate<D>::move(ObjectId object, const Box<D>& box) {
  const Status status = latest_.move(object, box);
  if (status == Status::unknown_id) return status;
  is_urgent_ |= status == Status::quarantined;
  if (std::exchange(is_changed_[object.index()], 1) == 0) changed_.push_back(object);
  return status;
}

template <int D>
Status Approximate<D>::remove(ObjectId object) {
  is_urgent_ = true;
  static_cast<void>(inner_->remove(object));
  return latest_.remove(object);
}

template <int D>
void Approximate<D>::step() {
  if (is_urgent_ || ++age_ >= how_.period) {
    place();
    inner_->step();
    is_urgent_ = false;
    age_ = 0;
  }
  if (how_.filter) filter();
}

/// Moves in `inner_` the boxes that changed since its last placement.
template <int D>
void Approximate<D>::place() {
  ids_.clear();
  boxes_.clear();
  for (const ObjectId object : changed_) {
    is_changed_[object.index()] = 0;
    if (latest_.state(object) == ObjectState::absent) continue;
    const Box<D> box = latest_.is_placed(object) ? handed_on(latest_.box(object)) : unplaceable<D>();
    if (box == given_[object.index()]) continue;
    given_[object.index()] = box;
    ids_.push_back(object);
    boxes_.push_back(box);
  }
  changed_.clear();
  static_cast<void>(inner_->move_many(ids_, boxes_));
}

template <int D>
void Approximate<D>::filter() {
  filtered_.clear();
  for (const Pair& pair : inner_->pairs())
    if (latest_.is_pair(pair.a, pair.b)) filtered_.push_back(pair);
}

template class Approximate<2>;
template class Approximate<3>;

}  // namespace kerf
