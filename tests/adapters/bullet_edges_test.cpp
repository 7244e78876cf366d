#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <btBulletDynamicsCommon.h>
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "sims3d/bullet/bullet_broad_phase.h"

namespace kerf {
namespace {

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
