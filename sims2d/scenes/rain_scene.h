#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/scene/scene.h"
#include "sims2d/scenes/rain.h"
#include "sims2d/world.h"

namespace kerf::inline sims2d {

/// The difference between two of these scenes: the fixed bodies and the rain of objects onto them.
struct RainPlan {
  Needs needs;
  std::vector<BodyPlan> fixed;
  Band band;
  Growth growth;
};

/// A scene in which more and more objects fall onto fixed bodies. The fixed bodies are the first objects.
class RainScene final : public Scene<2> {
 public:
  RainScene(BroadPhase<2>& broad_phase, const RainPlan& plan, std::uint64_t seed);

  [[nodiscard]] Needs needs() const override { return needs_; }
  void advance() override;
  [[nodiscard]] std::uint32_t step() const override { return world_.step(); }
  [[nodiscard]] std::span<const Body<2>> bodies() const override { return world_.bodies(); }
  [[nodiscard]] std::span<const Pair> pairs() const override { return world_.pairs(); }
  [[nodiscard]] std::span<const Pair> contacts() const override { return world_.contacts(); }
  [[nodiscard]] const World& world() const { return world_; }

 private:
  Needs needs_;
  World world_;
  Rain rain_;
};

}  // namespace kerf::inline sims2d
