#include "core/replay/recorded_looks.h"

namespace kerf {

template <int D>
const Looks<D>& RecordedLooks<D>::at(std::uint32_t step) {
  if (recording_.shape_count() == 0) return looks_;
  const std::uint32_t keyframe = recording_.keyframe_before(step);
  const bool is_near = step >= step_ && (keyframe <= step_ || step == step_ + 1);
  if (!is_near) {
    looks_ = keyframe == 0 ? Looks<D>() : recording_.keyframe_looks(keyframe);
    step_ = keyframe;
  }
  for (; step_ < step; ++step_) looks_.apply(recording_.step(step_ + 1).looks);
  return looks_;
}

template class RecordedLooks<2>;
template class RecordedLooks<3>;

}  // namespace kerf
