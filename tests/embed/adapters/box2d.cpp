#include <box2d/box2d.h>

#include <cstdio>

#include "sims2d/box2d/box2d_broad_phase.h"

int main() {
  b2World world({0, -10});
  kerf::Box2dBroadPhase broad_phase(world);  // Box2D's own stops working

  b2BodyDef def;
  b2PolygonShape floor_shape;
  floor_shape.SetAsBox(10, 1);
  world.CreateBody(&def)->CreateFixture(&floor_shape, 0);
  def.type = b2_dynamicBody;
  def.position.Set(0, 4);
  b2CircleShape ball_shape;
  ball_shape.m_radius = 0.5F;
  b2Body* const ball = world.CreateBody(&def);
  ball->CreateFixture(&ball_shape, 1);

  for (int step = 0; step < 120; ++step) {
    broad_phase.update(1.0F / 60);  // before each step, with its length
    world.Step(1.0F / 60, 8, 3);
  }
  std::printf("the ball lies at %.1f\n", static_cast<double>(ball->GetPosition().y));
}
