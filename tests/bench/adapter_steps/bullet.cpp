#include <btBulletDynamicsCommon.h>

#include <memory>
#include <utility>

#include "sims3d/bullet/bullet_broad_phase.h"
#include "tests/bench/adapter_steps/contest.h"

namespace kerf::adapters {
namespace {

btVector3 to_bullet(const std::vector<double>& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

class BulletScene {
 public:
  BulletScene(const Start& start, std::unique_ptr<btBroadphaseInterface> broad_phase)
      : broad_phase_(std::move(broad_phase)) {
    world_.setGravity({0, -static_cast<float>(start.gravity), 0});
    const auto side = static_cast<float>(start.side);
    for (int axis = 0; axis < 3; ++axis) {
      btVector3 normal(0, 0, 0);
      normal[axis] = 1;
      add(*walls_.emplace_back(std::make_unique<btStaticPlaneShape>(normal, 0.0F)), {0, 0, 0}, 0);
      if (axis == 1 && start.gravity > 0) continue;
      add(*walls_.emplace_back(std::make_unique<btStaticPlaneShape>(-normal, -side)), {0, 0, 0}, 0);
    }
    for (std::size_t k = 0; k < start.positions.size(); ++k) {
      add(ball_, to_bullet(start.positions[k]), 1);
      bodies_.back()->setLinearVelocity(to_bullet(start.velocities[k]));
      if (start.gravity == 0) bodies_.back()->setRestitution(1);
    }
  }
  BulletScene(const BulletScene&) = delete;
  BulletScene& operator=(const BulletScene&) = delete;
  ~BulletScene() {
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }
  void step() { world_.stepSimulation(static_cast<float>(kSeconds), 0); }
  void cast(const Start& start) {
    for (const std::vector<double>& ray : start.rays) {
      const btVector3 from = to_bullet(ray);
      const btVector3 to = to_bullet({ray[3], ray[4], ray[5]});
      btCollisionWorld::ClosestRayResultCallback hit(from, to);
      world_.rayTest(from, to, hit);
    }
  }

 private:
  void add(btCollisionShape& shape, const btVector3& position, float mass) {
    bodies_.push_back(
        std::make_unique<btRigidBody>(mass, nullptr, &shape, mass * btVector3(0.1F, 0.1F, 0.1F)));
    bodies_.back()->translate(position);
    world_.addRigidBody(bodies_.back().get());
  }

  btSphereShape ball_{0.5F};
  std::vector<std::unique_ptr<btCollisionShape>> walls_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  std::unique_ptr<btBroadphaseInterface> broad_phase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, broad_phase_.get(), &solver_, &configuration_};
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

}  // namespace

Contest bullet_contest(const Start& start) {
  const auto own = std::make_shared<BulletScene>(start, std::make_unique<btDbvtBroadphase>());
  const auto ours = std::make_shared<BulletScene>(start, std::make_unique<BulletBroadPhase>());
  return {"Bullet",
          "btDbvtBroadphase",
          [own] { own->step(); },
          [ours] { ours->step(); },
          {{"ray", [own](const Start& rays) { own->cast(rays); },
            [ours](const Start& rays) { ours->cast(rays); }}}};
}

}  // namespace kerf::adapters
