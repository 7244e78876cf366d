#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <btBulletDynamicsCommon.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "sims3d/bullet/bullet_broad_phase.h"

namespace kerf {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Balls in a world without gravity.
class BulletEdges : public testing::Test {
 protected:
  ~BulletEdges() override {
    for (const auto& ball : balls_) world_.removeRigidBody(ball.get());
    gContactEndedCallback = nullptr;
  }
  btRigidBody& add_ball(float x) {
    balls_.push_back(std::make_unique<btRigidBody>(1.0F, nullptr, &shape_, btVector3(1, 1, 1)));
    place(*balls_.back(), x);
    world_.addRigidBody(balls_.back().get());
    return *balls_.back();
  }
  static void place(btRigidBody& ball, float x) {
    const btTransform pose(btQuaternion::getIdentity(), {x, 0, 0});
    ball.setWorldTransform(pose);
    ball.setInterpolationWorldTransform(pose);
    ball.activate(true);
  }

  btSphereShape shape_{0.5F};
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  BulletBroadPhase broad_phase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broad_phase_, &solver_, &configuration_};
  std::vector<std::unique_ptr<btRigidBody>> balls_;
};

struct Collector final : btBroadphaseAabbCallback {
  bool process(const btBroadphaseProxy* proxy) override {
    found.push_back(proxy);
    return true;
  }
  std::vector<const btBroadphaseProxy*> found;
};

TEST_F(BulletEdges, ABodyMayComeWithoutABox) {
  world_.setGravity({0, 0, 0});
  add_ball(0);
  btRigidBody& lost = add_ball(kNan);
  ASSERT_NE(lost.getBroadphaseHandle(), nullptr);
  world_.stepSimulation(1.0F / 60, 0);
  btCollisionWorld::ClosestRayResultCallback ray({-9, 0, 0}, {9, 0, 0});
  world_.rayTest({-9, 0, 0}, {9, 0, 0}, ray);
  EXPECT_EQ(ray.m_collisionObject, balls_[0].get());
  place(lost, 0.9F);
  lost.setLinearVelocity({0, 0, 0});
  world_.performDiscreteCollisionDetection();
  EXPECT_EQ(dispatcher_.getNumManifolds(), 1);
}

TEST_F(BulletEdges, AProxyThatIsMadeWithoutABoxIsFoundFromItsFirstBoxOn) {
  const auto make = [&](const btVector3& min, const btVector3& max) {
    return broad_phase_.createProxy(min, max, 0, nullptr, 1, -1, &dispatcher_);
  };
  btBroadphaseProxy* const good = make({0, 0, 0}, {1, 1, 1});
  btBroadphaseProxy* const turned = make({1, 1, 1}, {0, 0, 0});
  btBroadphaseProxy* const never = make({0, 0, kNan}, {1, 1, 1});
  ASSERT_NE(turned, nullptr);
  ASSERT_NE(never, nullptr);
  const auto find = [&] {
    broad_phase_.calculateOverlappingPairs(&dispatcher_);
    Collector all;
    broad_phase_.aabbTest({-9, -9, -9}, {9, 9, 9}, all);
    return all.found;
  };
  EXPECT_THAT(find(), testing::ElementsAre(good));
  broad_phase_.setAabb(turned, {3, 1, 1}, {2, 0, 0}, &dispatcher_);
  EXPECT_THAT(find(), testing::ElementsAre(good));
  btVector3 min;
  btVector3 max;
  broad_phase_.getAabb(turned, min, max);
  EXPECT_EQ(min, btVector3(1, 1, 1));
  broad_phase_.getBroadphaseAabb(min, max);
  EXPECT_EQ(max, btVector3(1, 1, 1));
  broad_phase_.setAabb(turned, {1, 1, 1}, {2, 2, 2}, &dispatcher_);
  EXPECT_THAT(find(), testing::UnorderedElementsAre(good, turned));
  EXPECT_EQ(broad_phase_.getOverlappingPairCache()->getNumOverlappingPairs(), 1);
  broad_phase_.destroyProxy(good, &dispatcher_);
  broad_phase_.destroyProxy(turned, &dispatcher_);
  broad_phase_.resetPool(&dispatcher_);  // one is left
  EXPECT_EQ(make({0, 0, 0}, {1, 1, 1})->m_uniqueId, 4);
  broad_phase_.destroyProxy(never, &dispatcher_);
}

TEST_F(BulletEdges, ABoxThatIsNoneLeavesAProxyWhereItWas) {
  btBroadphaseProxy* const still = broad_phase_.createProxy({0, 0, 0}, {1, 1, 1}, 0, nullptr, 1, -1, nullptr);
  btBroadphaseProxy* const other =
      broad_phase_.createProxy({9, 0, 0}, {10, 1, 1}, 0, nullptr, 1, -1, nullptr);
  const auto found_at = [&](float x) {
    Collector all;
    broad_phase_.aabbTest({x, 0, 0}, {x + 1, 1, 1}, all);
    return all.found;
  };
  for (const auto& [min, max] : {std::pair(btVector3(kNan, kNan, kNan), btVector3(kNan, kNan, kNan)),
                                 std::pair(btVector3(8, 8, 8), btVector3(7, 7, 7)),
                                 std::pair(btVector3(5, 0, 0), btVector3(6, kNan, 1))}) {
    broad_phase_.setAabb(still, min, max, nullptr);
    broad_phase_.calculateOverlappingPairs(&dispatcher_);
    EXPECT_THAT(found_at(0), testing::ElementsAre(still));
    EXPECT_THAT(found_at(5), testing::IsEmpty());
    EXPECT_THAT(found_at(9), testing::ElementsAre(other));
    btVector3 low;
    btVector3 high;
    broad_phase_.getBroadphaseAabb(low, high);
    EXPECT_EQ(low, btVector3(0, 0, 0));
    EXPECT_EQ(high, btVector3(10, 1, 1));
  }
}

btDiscreteDynamicsWorld* world_of_victim = nullptr;
btRigidBody* victim = nullptr;

TEST_F(BulletEdges, WhatEndsAContactMayRemoveABodyOfWhichAPairBegins) {
  world_.setGravity({0, 0, 0});
  btRigidBody& first = add_ball(0);
  add_ball(0.9F);
  add_ball(20);
  btRigidBody& last = add_ball(30);
  world_.performDiscreteCollisionDetection();
  ASSERT_EQ(dispatcher_.getNumManifolds(), 1);
  world_of_victim = &world_;
  victim = &last;
  gContactEndedCallback = [](btPersistentManifold* const&) {
    if (victim != nullptr) world_of_victim->removeRigidBody(victim);
    victim = nullptr;
  };
  place(first, 10);
  place(last, 20.5F);
  world_.performDiscreteCollisionDetection();
  EXPECT_EQ(victim, nullptr);
  EXPECT_EQ(broad_phase_.getOverlappingPairCache()->getNumOverlappingPairs(), 0);
}

}  // namespace
}  // namespace kerf
