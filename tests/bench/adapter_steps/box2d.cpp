#include <box2d/box2d.h>

#include <memory>

#include "sims2d/box2d/box2d_broad_phase.h"
#include "tests/bench/adapter_steps/contest.h"

namespace kerf::adapters {
namespace {

class Box2dScene {
 public:
  Box2dScene(const Start& start, bool ours) : world_(b2Vec2(0, -static_cast<float>(start.gravity))) {
    const auto side = static_cast<float>(start.side);
    const b2Vec2 corners[] = {{0, 4 * side}, {0, 0}, {side, 0}, {side, 4 * side}};
    b2BodyDef def;
    b2Body& ground = *world_.CreateBody(&def);
    for (int k = 0; k < 3; ++k) {
      b2EdgeShape edge;
      edge.SetTwoSided(corners[k], corners[k + 1]);
      ground.CreateFixture(&edge, 0);
    }
    b2EdgeShape lid;
    lid.SetTwoSided({0, side}, {side, side});
    if (start.gravity == 0) ground.CreateFixture(&lid, 0);
    b2CircleShape ball;
    ball.m_radius = 0.5F;
    b2FixtureDef fixture;
    fixture.shape = &ball;
    fixture.density = 1;
    fixture.restitution = start.gravity == 0 ? 1 : 0;
    def.type = b2_dynamicBody;
    for (std::size_t k = 0; k < start.positions.size(); ++k) {
      def.position.Set(static_cast<float>(start.positions[k][0]), static_cast<float>(start.positions[k][1]));
      def.linearVelocity.Set(static_cast<float>(start.velocities[k][0]),
                             static_cast<float>(start.velocities[k][1]));
      world_.CreateBody(&def)->CreateFixture(&fixture);
    }
    if (ours) broad_phase_ = std::make_unique<Box2dBroadPhase>(world_);
  }
  void step() {
    constexpr auto kStep = static_cast<float>(kSeconds);
    if (broad_phase_) broad_phase_->update(kStep);
    world_.Step(kStep, 8, 3);
  }
  void cast(const Start& start) {
    struct Nearest final : b2RayCastCallback {
      float ReportFixture(b2Fixture* /*fixture*/, const b2Vec2& /*point*/, const b2Vec2& /*normal*/,
                          float fraction) override {
        return fraction;
      }
    } nearest;
    for (const std::vector<double>& ray : start.rays) {
      const b2Vec2 from(static_cast<float>(ray[0]), static_cast<float>(ray[1]));
      const b2Vec2 to(static_cast<float>(ray[2]), static_cast<float>(ray[3]));
      if (broad_phase_) {
        broad_phase_->ray_cast(nearest, from, to);
      } else {
        world_.RayCast(&nearest, from, to);
      }
    }
  }

 private:
  b2World world_;
  std::unique_ptr<Box2dBroadPhase> broad_phase_;
};

}  // namespace

Contest box2d_contest(const Start& start) {
  const auto own = std::make_shared<Box2dScene>(start, false);
  const auto ours = std::make_shared<Box2dScene>(start, true);
  return {"Box2D",
          "b2BroadPhase",
          [own] { own->step(); },
          [ours] { ours->step(); },
          {{"ray", [own](const Start& rays) { own->cast(rays); },
            [ours](const Start& rays) { ours->cast(rays); }}}};
}

}  // namespace kerf::adapters
