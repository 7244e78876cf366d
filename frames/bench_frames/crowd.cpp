#include "frames/bench_frames/crowd.h"

#include <cmath>

namespace kerf {
namespace {

/// n boxes of side s in a cube of side a overlap in about n^2/2 (2s/a)^3 pairs; that is n/2 for a = 2 s
/// n^(1/3).
float side_for(std::uint32_t boxes) { return 2 * std::cbrt(static_cast<float>(boxes)); }

}  // namespace

Crowd::Crowd(std::uint32_t boxes) : side_(side_for(boxes)) {
  Random random(7);
  for (std::uint32_t i = 0; i < boxes; ++i) {
    Body<3> body;
    Brick<3> brick;
    for (int axis = 0; axis < 3; ++axis) {
      body.pose.position[axis] = static_cast<float>(random.uniform(0, side_));
      brick.half[axis] = static_cast<float>(random.uniform(0.3, 0.7));
    }
    body.shape = brick;
    Vector<3> velocity;
    for (int axis = 0; axis < 3; ++axis) velocity[axis] = static_cast<float>(random.uniform(-0.05, 0.05));
    velocities_.push_back(velocity);
    bodies_.push_back(body);
    bodies_.back().box = box_of(i);
    (void)tree_.insert({i}, bodies_.back().box, Mobility::moving);
  }
  tree_.step();
}

Box<3> Crowd::box_of(std::size_t k) const {
  const Vector<3>& half = std::get<Brick<3>>(bodies_[k].shape).half;
  return {bodies_[k].pose.position - half, bodies_[k].pose.position + half};
}

void Crowd::advance() {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    Vector<3>& position = bodies_[k].pose.position;
    for (int axis = 0; axis < 3; ++axis) {
      position[axis] += velocities_[k][axis];
      if (position[axis] < 0 || position[axis] > side_) velocities_[k][axis] = -velocities_[k][axis];
    }
    bodies_[k].box = box_of(k);
    (void)tree_.move({static_cast<std::uint32_t>(k)}, bodies_[k].box);
  }
  tree_.step();
  events_ = tree_.trace().take();
}

FrameInput<3> Crowd::input() const {
  FrameInput<3> input;
  input.bodies = bodies_;
  input.tree = &tree_.tree();
  input.pairs = tree_.pairs();
  input.events = events_;
  input.caption.scene = "crowd";
  input.caption.broad_phase = "kerf-paper";
  input.caption.step = tree_.steps();
  input.caption.objects = static_cast<std::uint32_t>(bodies_.size());
  input.caption.moving = input.caption.objects;
  input.caption.pairs = tree_.pairs().size();
  input.caption.statistics = tree_.statistics();
  return input;
}

}  // namespace kerf
