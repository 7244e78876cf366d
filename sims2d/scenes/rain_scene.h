#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/world_scene.h"
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
class RainScene final : public WorldScene<2, Box2dWorld> {
 public:
  RainScene(BroadPhase<2>& broad_phase, const RainPlan& plan, std::uint64_t seed);

 private:
  void act() override { rain_.fall(world(), step() + 1); }

  Rain rain_;
};

}  // namespace kerf::inline sims2d
