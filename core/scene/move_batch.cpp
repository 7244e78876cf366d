#include "core/scene/move_batch.h"

namespace kerf {

template <int D>
std::optional<typename MoveBatch<D>::Refusal> MoveBatch<D>::send(BroadPhase<D>& broad_phase) {
  std::optional<Refusal> refusal;
  // The status covers all objects; only if it is not ok is each moved by itself.
  if (!volumes_.empty() || broad_phase.move_many(objects_, boxes_) != Status::ok)
    refusal = first_refusal(broad_phase);
  objects_.clear();
  boxes_.clear();
  volumes_.clear();
  return refusal;
}

/// Moves the objects one by one; to move one to the same box twice changes nothing.
template <int D>
std::optional<typename MoveBatch<D>::Refusal> MoveBatch<D>::first_refusal(BroadPhase<D>& broad_phase) const {
  std::optional<Refusal> first;
  for (std::size_t k = 0; k < objects_.size(); ++k) {
    const Status status = volumes_.empty() ? broad_phase.move(objects_[k], boxes_[k])
                                           : broad_phase.move(objects_[k], volumes_[k]);
    if (!first && status != Status::ok && status != Status::clamped) first = Refusal{objects_[k], status};
  }
  return first;
}

template class MoveBatch<2>;
template class MoveBatch<3>;

}  // namespace kerf
