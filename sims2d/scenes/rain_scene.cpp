#include "sims2d/scenes/rain_scene.h"

namespace kerf::inline sims2d {

RainScene::RainScene(BroadPhase<2>& broad_phase, const RainPlan& plan, std::uint64_t seed)
    : needs_(plan.needs), world_(broad_phase), rain_(plan.band, plan.growth, seed) {
  for (const BodyPlan& body : plan.fixed) world_.add(body);
}

void RainScene::advance() {
  rain_.fall(world_, world_.step() + 1);
  world_.advance();
}

}  // namespace kerf::inline sims2d
