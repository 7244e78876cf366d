#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "sims2d/box2d/box2d_broad_phase.h"

namespace kerf {
namespace {

/// Two balls at rest, of which the first grows in place: how many contacts there are after each step.
std::vector<int> contacts_of_growing(bool ours, b2BodyType type, bool awake) {
  b2World world({0, 0});
  std::unique_ptr<Box2dBroadPhase> broad_phase;
  if (ours) broad_phase = std::make_unique<Box2dBroadPhase>(world);
  const auto add = [&](float x, b2BodyType of) {
    b2BodyDef def;
    def.type = of;
    def.allowSleep = !awake;
    def.position.Set(x, 0);
    b2CircleShape shape;
    shape.m_radius = 0.5F;
    b2Body* const body = world.CreateBody(&def);
    body->CreateFixture(&shape, 1);
    if (!awake) body->SetAwake(false);
    return body;
  };
  b2Body* const grows = add(0, type);
  add(5, b2_dynamicBody);
  std::vector<int> contacts;
  for (int step = 0; step < 30; ++step) {
    if (step == 10) grows->GetFixtureList()->GetShape()->m_radius = 4.8F;
    if (step == 20) grows->SetAwake(true);
    if (ours) broad_phase->update(1.0F / 60);
    world.Step(1.0F / 60, 8, 3);
    contacts.push_back(world.GetContactCount());
  }
  return contacts;
}

TEST(Box2dShapes, ThatChangeInPlaceAreSeenWhereBox2dSeesThem) {
  for (const b2BodyType type : {b2_staticBody, b2_kinematicBody, b2_dynamicBody})
    for (const bool awake : {false, true}) {
      const std::vector<int> theirs = contacts_of_growing(false, type, awake);
      const std::vector<int> ours = contacts_of_growing(true, type, awake);
      for (const std::size_t step : {9U, 12U, 19U, 22U, 29U})
        EXPECT_EQ(ours[step], theirs[step]) << "type " << type << ", awake " << awake << ", step " << step;
    }
  EXPECT_EQ(contacts_of_growing(true, b2_dynamicBody, true)[12], 1);
}

}  // namespace
}  // namespace kerf
