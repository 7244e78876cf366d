#pragma once

#include <cstdint>

#include "core/scene/scene.h"
#include "sims3d/world.h"

namespace kerf {

/// A scene that is a world and an action before each step.
class WorldScene : public Scene<3> {
 public:
  WorldScene(BroadPhase<3>& broad_phase, const Needs& needs, std::uint64_t seed, const WorldSettings& physics)
      : needs_(needs), world_(broad_phase, seed, physics) {}

  [[nodiscard]] Needs needs() const final { return needs_; }
  void advance() final {
    act();
    world_.advance();
  }
  [[nodiscard]] std::uint32_t step() const final { return world_.step(); }
  [[nodiscard]] std::span<const Body<3>> bodies() const final { return world_.bodies(); }
  [[nodiscard]] std::span<const Pair> pairs() const final { return world_.pairs(); }
  [[nodiscard]] std::span<const Pair> contacts() const final { return world_.contacts(); }

 protected:
  /// The action before the step; it sees the poses and contacts of the step before.
  virtual void act() = 0;
  [[nodiscard]] OdeWorld& world() { return world_; }

 private:
  Needs needs_;
  OdeWorld world_;
};

}  // namespace kerf
