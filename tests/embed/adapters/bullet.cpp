#include <btBulletDynamicsCommon.h>

#include <cstdio>

#include "sims3d/bullet/bullet_broad_phase.h"

int main() {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  kerf::BulletBroadPhase broad_phase;  // in place of btDbvtBroadphase
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broad_phase, &solver, &configuration);

  btBoxShape floor_shape({10, 1, 10});
  btSphereShape ball_shape(0.5F);
  btRigidBody floor(0, nullptr, &floor_shape);
  btRigidBody ball(1, nullptr, &ball_shape, {0.1F, 0.1F, 0.1F});
  ball.translate({0, 4, 0});
  world.addRigidBody(&floor);
  world.addRigidBody(&ball);

  for (int step = 0; step < 120; ++step) world.stepSimulation(1.0F / 60);
  std::printf("the ball lies at %.1f\n", static_cast<double>(ball.getWorldTransform().getOrigin().y()));
  world.removeRigidBody(&ball);
  world.removeRigidBody(&floor);
}
