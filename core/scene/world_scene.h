#pragma once

#include <cstdint>
#include <span>

#include "core/scene/scene.h"

namespace kerf {

/// A scene that is an engine's world and an action before each step.
template <int D, class World>
class WorldScene : public Scene<D> {
 public:
  /// The world is made of the broad phase and `physics`.
  template <class... Physics>
  WorldScene(BroadPhase<D>& broad_phase, const Needs& needs, const Physics&... physics)
      : needs_(needs), world_(broad_phase, physics...) {}

  [[nodiscard]] Needs needs() const final { return needs_; }
  void advance() final {
    act();
    world_.advance();
  }
  [[nodiscard]] std::uint32_t step() const final { return world_.step(); }
  [[nodiscard]] std::span<const Body<D>> bodies() const final { return world_.bodies(); }
  [[nodiscard]] std::span<const Pair> pairs() const final { return world_.pairs(); }
  [[nodiscard]] std::span<const Pair> contacts() const final { return world_.contacts(); }
  [[nodiscard]] const World& world() const { return world_; }

 protected:
  /// The action before the step; it sees the poses and contacts of the step before.
  virtual void act() = 0;
  [[nodiscard]] World& world() { return world_; }

 private:
  Needs needs_;
  World world_;
};

}  // namespace kerf
