#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/bsp/bsp.h"
#include "core/trace/event_facts.h"
#include "tests/support/boxes.h"
#include "tests/support/config_of.h"
#include "viz/draw/frame_renderer.h"

namespace kerf::test {

/// The tree and the boxes before and after a step in which an operator acted.
template <int D>
struct OperatorMoment {
  Event event;
  Tree<D> before;
  Tree<D> after;
  std::vector<Body<D>> bodies_before;
  std::vector<Body<D>> bodies_after;
  std::vector<Pair> pairs_before;
  std::vector<Pair> pairs_after;
  Statistics statistics;
};

/// Boxes that fly about in a swarm until each operator has acted.
template <int D>
class OperatorMoments {
 public:
  OperatorMoments()
      : tree_(config_of("min_threshold=8,max_threshold=12,schedule_interval=2,budget_divisor=1,"
                        "max_redundancy=0.3,swap_share=1,merge_fraction=0.75")) {
    Random random(11);
    for (std::uint32_t i = 0; i < kBoxes; ++i) {
      Body<D> body;
      body.box = random_box<D>(random, kWorld, 0.6);
      body.shape = Brick<D>{body.box.extent() * 0.5F};
      body.pose.position = body.box.center();
      bodies_.push_back(body);
      velocities_.push_back(random_point<D>(random, -0.25, 0.25));
      (void)tree_.insert(ObjectId{i}, body.box, Mobility::moving);
    }
    for (step_ = 1; step_ <= kMostSteps && !complete(); ++step_) step();
  }

  [[nodiscard]] const OperatorMoment<D>* of(Operator op) const {
    const auto& moment = moments_[static_cast<std::size_t>(op)];
    return moment ? &*moment : nullptr;
  }

 private:
  static constexpr std::uint32_t kBoxes = 90;
  static constexpr std::uint32_t kMostSteps = 600;
  static constexpr double kWorld = 12;

  [[nodiscard]] bool complete() const {
    return std::ranges::all_of(moments_, [](const auto& moment) { return moment.has_value(); });
  }

  /// Boxes fly towards one corner and back: what is crowded becomes empty and full again.
  void move() {
    for (std::uint32_t i = 0; i < kBoxes; ++i) {
      Body<D>& body = bodies_[i];
      for (int axis = 0; axis < D; ++axis) {
        Scalar& speed = velocities_[i][axis];
        const Scalar drift = step_ / 100 % 2 == 0 ? -0.04F : 0.04F;
        const Scalar to = std::clamp(body.pose.position[axis] + speed + drift, 0.0F, Scalar{kWorld});
        if (to == 0 || to == Scalar{kWorld}) speed = -speed;
        body.pose.position[axis] = to;
      }
      const Vector<D> half = std::get<Brick<D>>(body.shape).half;
      body.box = {body.pose.position - half, body.pose.position + half};
      (void)tree_.move(ObjectId{i}, body.box);
    }
  }

  void step() {
    const Tree<D> before = tree_.tree();
    const std::vector<Body<D>> bodies_before = bodies_;
    const std::vector<Pair> pairs_before(tree_.pairs().begin(), tree_.pairs().end());
    move();
    tree_.step();
    for (const Event& event : tree_.trace().take()) {
      const auto* acted = acted_of(event);
      if (acted == nullptr || step_ < 3) continue;
      auto& moment = moments_[static_cast<std::size_t>(acted->op)];
      if (moment) continue;
      moment = {event,
                before,
                tree_.tree(),
                bodies_before,
                bodies_,
                pairs_before,
                {tree_.pairs().begin(), tree_.pairs().end()},
                tree_.statistics()};
    }
  }

  Bsp<D, EventLog> tree_;
  std::uint32_t step_ = 0;
  std::vector<Body<D>> bodies_;
  std::vector<Vector<D>> velocities_;
  std::array<std::optional<OperatorMoment<D>>, kOperatorCount> moments_;
};

}  // namespace kerf::test
