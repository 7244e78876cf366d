#pragma once

#include <cstdint>
#include <span>

#include "core/scene/scene.h"
#include "sims2d/world.h"

namespace kerf::inline sims2d {

/// A scene that is a world and an action before each step.
class WorldScene : public Scene<2> {
 public:
  WorldScene(BroadPhase<2>& broad_phase, const Needs& needs, Scalar gravity = Box2dWorld::kGravity)
      : needs_(needs), world_(broad_phase, gravity) {}

  [[nodiscard]] Needs needs() const final { return needs_; }
  void advance() final {
    act();
    world_.advance();
  }
  [[nodiscard]] std::uint32_t step() const final { return world_.step(); }
  [[nodiscard]] std::span<const Body<2>> bodies() const final { return world_.bodies(); }
  [[nodiscard]] std::span<const Pair> pairs() const final { return world_.pairs(); }
  [[nodiscard]] std::span<const Pair> contacts() const final { return world_.contacts(); }
  [[nodiscard]] const Box2dWorld& world() const { return world_; }

 protected:
  /// The action before the step; it sees the poses and contacts of the step before.
  virtual void act() = 0;
  [[nodiscard]] Box2dWorld& world() { return world_; }

 private:
  Needs needs_;
  Box2dWorld world_;
};

}  // namespace kerf::inline sims2d
