#include "viz/draw/gliding_box.h"

#include <algorithm>

namespace kerf {
namespace {

constexpr int kFrames = 4;  ///< more would keep a film from standing still for long

}  // namespace

template <int D>
void GlidingBox<D>::jump(const Box<D>& goal) {
  box_ = goal_ = goal;
  frames_left_ = 0;
}

template <int D>
void GlidingBox<D>::go_on(const Box<D>& goal, const std::optional<Box<D>>& needed) {
  if (!box_ || !contains(goal, *box_)) return jump(goal);  // it does not grow, but is another one
  if (goal != goal_) frames_left_ = kFrames;
  goal_ = goal;
  if (frames_left_ == 0) return;
  if (frames_left_ == 1) return jump(goal);  // without what rounding would leave of the way
  const Scalar part = 1 / static_cast<Scalar>(frames_left_--);
  for (int i = 0; i < D; ++i) {
    box_->min[i] += part * (goal.min[i] - box_->min[i]);
    box_->max[i] += part * (goal.max[i] - box_->max[i]);
  }
  if (needed) box_ = join(*box_, *needed);
}

template class GlidingBox<2>;
template class GlidingBox<3>;

}  // namespace kerf
