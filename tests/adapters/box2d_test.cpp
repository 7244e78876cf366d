#include <box2d/box2d.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "sims2d/box2d/box2d_broad_phase.h"

namespace kerf {
namespace {

using Touching = std::set<std::pair<b2Body*, b2Body*>>;

constexpr float kSeconds = 1.0F / 60;

float pick(Random& random, double low, double high) { return static_cast<float>(random.uniform(low, high)); }

class Box2dBroadPhaseTest : public testing::Test {
 protected:
  b2Body& add(b2BodyType type, float x, float y, const b2Shape& shape) {
    b2BodyDef def;
    def.type = type;
    def.position.Set(x, y);
    def.allowSleep = false;
    b2Body& body = *world_.CreateBody(&def);
    body.CreateFixture(&shape, 1);
    return body;
  }
  b2Body& add_box(b2BodyType type, float x, float y, float half_width, float half_height) {
    b2PolygonShape shape;
    shape.SetAsBox(half_width, half_height);
    return add(type, x, y, shape);
  }
  b2Body& add_ball(float x, float y, float radius = 0.5F) {
    b2CircleShape shape;
    shape.m_radius = radius;
    return add(b2_dynamicBody, x, y, shape);
  }
  void step(int times = 1) {
    for (int i = 0; i < times; ++i) {
      broad_phase_.update(kSeconds);
      world_.Step(kSeconds, 8, 3);
    }
  }
  int touching() const {
    int count = 0;
    for (const b2Contact* contact = world_.GetContactList(); contact != nullptr; contact = contact->GetNext())
      count += contact->IsTouching() ? 1 : 0;
    return count;
  }

  b2World world_{b2Vec2(0, -10)};
  Box2dBroadPhase broad_phase_{world_};
};

Touching touching_bodies(b2World& world) {
  Touching found;
  for (b2Contact* contact = world.GetContactList(); contact != nullptr; contact = contact->GetNext())
    if (contact->IsTouching())
      found.insert(std::minmax(contact->GetFixtureA()->GetBody(), contact->GetFixtureB()->GetBody()));
  return found;
}

/// What Box2D finds by itself: in a second world with the same bodies at the same poses.
Touching by_box2d(b2World& world) {
  b2World copy(b2Vec2(0, 0));
  for (b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    b2BodyDef def;
    def.type = body->GetType();
    def.position = body->GetPosition();
    def.angle = body->GetAngle();
    def.userData.pointer = reinterpret_cast<std::uintptr_t>(body);
    b2Body* const made = copy.CreateBody(&def);
    for (b2Fixture* fixture = body->GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext())
      made->CreateFixture(fixture->GetShape(), 1);
  }
  copy.Step(0, 1, 1);
  Touching found;
  for (const auto& [a, b] : touching_bodies(copy))
    found.insert(std::minmax(reinterpret_cast<b2Body*>(a->GetUserData().pointer),
                             reinterpret_cast<b2Body*>(b->GetUserData().pointer)));
  return found;
}

TEST_F(Box2dBroadPhaseTest, ContactsAreThoseOfBox2dWhileBodiesComeAndGo) {
  const b2Vec2 hills[] = {{-20, 3}, {-10, 0}, {0, 1}, {10, 0}, {20, 3}};
  b2ChainShape ground;
  ground.CreateChain(hills, 5, {-30, 5}, {30, 5});  // one fixture, four children
  add(b2_staticBody, 0, 0, ground);
  for (int column = 0; column < 6; ++column)
    for (int row = 0; row < 8; ++row)
      add_box(b2_dynamicBody, 2.0F * static_cast<float>(column) - 5, 2 + static_cast<float>(row), 0.5F, 0.5F);
  Random random(9);
  std::vector<b2Body*> balls;
  std::size_t most = 0;
  for (int round = 0; round < 600; ++round) {
    if (round % 4 == 0) balls.push_back(&add_ball(pick(random, -15, 15), pick(random, 4, 12)));
    if (round % 6 == 5) {
      const std::size_t gone = random.below(static_cast<std::uint32_t>(balls.size()));
      world_.DestroyBody(balls[gone]);
      balls.erase(balls.begin() + static_cast<std::ptrdiff_t>(gone));
    }
    const Touching expected = by_box2d(world_);
    broad_phase_.update(kSeconds);
    world_.Step(kSeconds, 8, 3);
    ASSERT_EQ(touching_bodies(world_), expected) << "round " << round;
    most = std::max(most, expected.size());
  }
  EXPECT_GT(most, 40U);
}

TEST_F(Box2dBroadPhaseTest, FiltersAndJointsWork) {
  add_box(b2_staticBody, 0, 0, 5, 1);
  b2Body& through = add_ball(-3, 1.4F);
  b2Filter filter;
  filter.maskBits = 0;
  through.GetFixtureList()->SetFilterData(filter);
  b2Body& first = add_ball(2, 1.4F);
  b2Body& second = add_ball(2.5F, 1.4F);
  b2RevoluteJointDef joint;
  joint.Initialize(&first, &second, {2.2F, 1.4F});  // which do not collide
  world_.CreateJoint(&joint);
  step(2);
  EXPECT_EQ(touching(), 2);
  filter.maskBits = 0xFFFF;
  through.GetFixtureList()->SetFilterData(filter);
  step(1);
  EXPECT_EQ(touching(), 3);
  filter.maskBits = 0;
  through.GetFixtureList()->SetFilterData(filter);
  step(1);
  EXPECT_EQ(touching(), 2);
}

TEST_F(Box2dBroadPhaseTest, FixturesAndBodiesChangeAsTheyLike) {
  b2Body& floor = add_box(b2_staticBody, 0, 0, 5, 1);
  b2Body& ball = add_ball(0, 1.4F);
  step();
  EXPECT_EQ(touching(), 1);
  ball.SetEnabled(false);
  step();
  EXPECT_EQ(world_.GetContactCount(), 0);
  ball.SetEnabled(true);
  step();
  EXPECT_EQ(touching(), 1);
  ball.DestroyFixture(ball.GetFixtureList());
  b2CircleShape shape;
  shape.m_radius = 0.5F;
  ball.CreateFixture(&shape, 1);  // perhaps at the same address
  step();
  EXPECT_EQ(touching(), 1);
  ball.SetType(b2_staticBody);
  step();
  EXPECT_EQ(world_.GetContactCount(), 0);
  ball.SetType(b2_dynamicBody);
  step();
  EXPECT_EQ(touching(), 1);
  floor.SetTransform({0, -5}, 0);
  step();
  EXPECT_EQ(world_.GetContactCount(), 0);
  EXPECT_EQ(broad_phase_.world().size(), 2U);
  b2Body& late = add_box(b2_staticBody, 3, -3.6F, 0.5F, 0.5F);  // in the floor
  step();
  EXPECT_EQ(world_.GetContactCount(), 0);
  late.SetType(b2_dynamicBody);
  step();
  EXPECT_EQ(touching(), 1);
}

TEST_F(Box2dBroadPhaseTest, WhatIsFastHitsAThinWall) {
  add_box(b2_staticBody, 0, 0, 0.05F, 5);
  b2Body& shot = add_ball(-4.2F, 0, 0.1F);
  shot.SetBullet(true);
  shot.SetLinearVelocity({500, 0});  // 8 units a step
  step(3);
  EXPECT_LT(shot.GetPosition().x, 0);
}

TEST_F(Box2dBroadPhaseTest, WhatSpinsFastHitsAPost) {
  world_.SetGravity(b2Vec2_zero);
  b2Body& rod = add_box(b2_dynamicBody, 0, 0, 5, 0.05F);
  add_box(b2_staticBody, 3.6F, 3.2F, 0.3F, 0.3F);  // outside the rod's present box
  rod.SetBullet(true);
  rod.SetAngularVelocity(48);  // 0.8 radians a step
  step();
  EXPECT_EQ(world_.GetContactCount(), 1);
  EXPECT_LT(rod.GetAngularVelocity(), 47);
}

TEST_F(Box2dBroadPhaseTest, FixturesThatComeBetweenUpdateAndStepAsOthersGoAreFollowed) {
  b2Body& gone = add_ball(0, 0);
  add_ball(0.9F, 0);
  step();
  broad_phase_.update(kSeconds);
  ASSERT_EQ(world_.GetContactCount(), 1);
  world_.DestroyBody(&gone);
  b2Vec2 line[8];
  for (int k = 0; k < 8; ++k) line[k].Set(24 - 2 * static_cast<float>(k), 0);
  b2ChainShape ground;
  ground.CreateChain(line, 8, {26, 0}, {9, 0});
  add(b2_staticBody, 0, 0, ground);
  add_ball(11, 0.4F);
  world_.Step(kSeconds, 8, 3);  // which finds as many contacts as have gone
  for (int i = 0; i < 10; ++i) {
    const Touching expected = by_box2d(world_);
    step();
    EXPECT_EQ(touching_bodies(world_), expected);
    EXPECT_EQ(expected.size(), 1U);
  }
}

struct Collector final : b2QueryCallback, b2RayCastCallback {
  bool ReportFixture(b2Fixture* fixture) override {
    found.push_back(fixture->GetBody());
    return true;
  }
  float ReportFixture(b2Fixture* fixture, const b2Vec2& /*point*/, const b2Vec2& /*normal*/,
                      float /*fraction*/) override {
    found.push_back(fixture->GetBody());
    return 1;
  }
  std::vector<const b2Body*> found;
};

struct NearestHit final : b2RayCastCallback {
  float ReportFixture(b2Fixture* fixture, const b2Vec2& /*point*/, const b2Vec2& /*normal*/,
                      float fraction) override {
    body = fixture->GetBody();
    at = fraction;
    return fraction;
  }
  b2Body* body = nullptr;
  float at = 1;
};

TEST_F(Box2dBroadPhaseTest, QueriesAndRaysFindWhatBox2dFinds) {
  Random random(10);
  b2World plain(b2Vec2(0, 0));
  for (int i = 0; i < 80; ++i) {
    b2Body& body = add_box(b2_dynamicBody, pick(random, -9, 9), pick(random, -9, 9), 0.4F, 0.2F);
    b2BodyDef def;
    def.position = body.GetPosition();
    def.userData.pointer = reinterpret_cast<std::uintptr_t>(&body);
    plain.CreateBody(&def)->CreateFixture(body.GetFixtureList()->GetShape(), 1);
  }
  broad_phase_.update(kSeconds);
  int hits = 0;
  for (int i = 0; i < 200; ++i) {
    const b2Vec2 from(pick(random, -12, 12), pick(random, -12, 12));
    const b2Vec2 to(pick(random, -12, 12), pick(random, -12, 12));
    NearestHit ours;
    NearestHit theirs;
    broad_phase_.ray_cast(ours, from, to);
    plain.RayCast(&theirs, from, to);
    ASSERT_EQ(ours.body == nullptr, theirs.body == nullptr);
    if (theirs.body == nullptr) continue;
    ++hits;
    ASSERT_EQ(ours.body, reinterpret_cast<b2Body*>(theirs.body->GetUserData().pointer));
    ASSERT_EQ(ours.at, theirs.at);
  }
  EXPECT_GT(hits, 100);
  const b2Body& first = add_ball(50, 50);
  const b2Body& second = add_ball(52, 50);
  add_ball(60, 50);
  broad_phase_.update(kSeconds);
  Collector near;
  broad_phase_.query(near, {{49, 49}, {53, 51}});
  EXPECT_THAT(near.found, testing::UnorderedElementsAre(&first, &second));
}

TEST_F(Box2dBroadPhaseTest, QueriesSeeWhatCameMovedAndWent) {
  Random random(11);
  std::vector<b2Body*> balls;
  const auto add_anywhere = [&] { balls.push_back(&add_ball(pick(random, 0, 20), pick(random, 0, 20))); };
  for (int i = 0; i < 100; ++i) add_anywhere();
  std::size_t found = 0;
  for (int round = 0; round < 200; ++round) {
    world_.DestroyBody(balls.front());
    balls.erase(balls.begin());
    add_anywhere();
    balls[random.below(100)]->SetTransform({pick(random, 0, 20), pick(random, 0, 20)}, 0);
    broad_phase_.update(kSeconds);
    for (int asked = 0; asked < 4; ++asked) {
      const b2Vec2 low(pick(random, 0, 18), pick(random, 0, 18));
      const b2AABB box{low, low + b2Vec2(3, 3)};
      const Box<2> here{{{low.x, low.y}}, {{box.upperBound.x, box.upperBound.y}}};
      std::vector<const b2Body*> expected;
      for (const b2Body* ball : balls)
        if (overlaps(padded_box(*ball->GetFixtureList()->GetShape(), ball->GetTransform()), here))
          expected.push_back(ball);
      Collector near;
      broad_phase_.query(near, box);
      ASSERT_THAT(near.found, testing::UnorderedElementsAreArray(expected)) << round;
      found += expected.size();
    }
  }
  EXPECT_GT(found, 1000U);
}

TEST_F(Box2dBroadPhaseTest, QueriesReportNothingThatWasDestroyedOrDisabledSinceTheUpdate) {
  std::vector<b2Body*> balls;
  for (int i = 0; i < 6; ++i) balls.push_back(&add_ball(2 * static_cast<float>(i), 0));
  b2CircleShape shape;
  shape.m_radius = 0.5F;
  shape.m_p.Set(0, 1);
  b2Fixture* const second = balls[5]->CreateFixture(&shape, 1);
  step();
  const auto expect = [&](const std::vector<const b2Body*>& bodies, std::size_t seconds) {
    for (int asked = 0; asked < 200; ++asked) {  // often enough for the index
      Collector near;
      broad_phase_.query(near, {{-9, -9}, {19, 9}});
      Collector hit;
      broad_phase_.ray_cast(hit, {-9, 0.2F}, {19, 0.2F});
      ASSERT_THAT(hit.found, testing::UnorderedElementsAreArray(bodies));
      hit.found.insert(hit.found.end(), seconds, balls[5]);
      ASSERT_THAT(near.found, testing::UnorderedElementsAreArray(hit.found));
    }
  };
  expect({balls[0], balls[1], balls[2], balls[3], balls[4], balls[5]}, 1);
  world_.DestroyBody(balls[1]);
  expect({balls[0], balls[2], balls[3], balls[4], balls[5]}, 1);
  balls[5]->DestroyFixture(second);
  expect({balls[0], balls[2], balls[3], balls[4], balls[5]}, 0);
  world_.DestroyBody(balls[2]);
  add_ball(4, 0);  // at its address, in Box2D's memory: known from the next update on
  expect({balls[0], balls[3], balls[4], balls[5]}, 0);
  balls[3]->SetEnabled(false);
  expect({balls[0], balls[4], balls[5]}, 0);
  balls[4]->DestroyFixture(balls[4]->GetFixtureList());
  balls[4]->CreateFixture(&shape, 1);
  expect({balls[0], balls[5]}, 0);
  world_.DestroyBody(balls[5]);
  add_ball(10, 0);
  expect({balls[0]}, 0);
  step();
  Collector all;
  broad_phase_.query(all, {{-9, -9}, {19, 9}});
  EXPECT_EQ(all.found.size(), 4U);
}

TEST_F(Box2dBroadPhaseTest, QueriesKnowWhichOfManyFixturesOfABodyAreLeft) {
  b2Body& ground = add_box(b2_staticBody, 0, 0, 0.4F, 0.4F);
  b2PolygonShape tile;
  for (int i = 1; i < 200; ++i) {
    tile.SetAsBox(0.4F, 0.4F, {static_cast<float>(i), 0}, 0);
    ground.CreateFixture(&tile, 0);
  }
  step();
  for (int left = 200; left > 150; --left) {
    Collector all;
    broad_phase_.query(all, {{-1, -1}, {200, 1}});
    ASSERT_EQ(all.found.size(), static_cast<std::size_t>(left));
    b2Fixture* gone = ground.GetFixtureList();
    for (int i = 0; i < left / 2; ++i) gone = gone->GetNext();
    ground.DestroyFixture(gone);
  }
}

}  // namespace
}  // namespace kerf
