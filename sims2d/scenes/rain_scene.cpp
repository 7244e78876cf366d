#include "sims2d/scenes/rain_scene.h"

namespace kerf::inline sims2d {

RainScene::RainScene(BroadPhase<2>& broad_phase, const RainPlan& plan, std::uint64_t seed)
    : WorldScene(broad_phase, plan.needs), rain_(plan.band, plan.growth, seed) {
  for (const BodyPlan& body : plan.fixed) world().add(body);
}

}  // namespace kerf::inline sims2d
