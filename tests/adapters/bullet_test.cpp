#include <BulletCollision/CollisionDispatch/btGhostObject.h>
#include <btBulletDynamicsCommon.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "sims3d/bullet/bullet_broad_phase.h"

namespace kerf {
namespace {

using Touching = std::set<std::pair<int, int>>;

float pick(Random& random, double low, double high) { return static_cast<float>(random.uniform(low, high)); }

btTransform at(const btVector3& position) { return btTransform(btQuaternion::getIdentity(), position); }

/// A Bullet world with any broad phase. Bodies are numbered; nothing sleeps.
class BulletWorld {
 public:
  explicit BulletWorld(btBroadphaseInterface& broad_phase)
      : dispatcher_(&configuration_), world_(&dispatcher_, &broad_phase, &solver_, &configuration_) {
    world_.getDispatchInfo().m_deterministicOverlappingPairs = true;
  }
  ~BulletWorld() {
    for (const auto& body : bodies_)
      if (body) world_.removeRigidBody(body.get());
  }
  BulletWorld(const BulletWorld&) = delete;
  BulletWorld& operator=(const BulletWorld&) = delete;

  void add(std::unique_ptr<btCollisionShape> shape, const btVector3& position, float mass) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0) shape->calculateLocalInertia(mass, inertia);
    bodies_.push_back(std::make_unique<btRigidBody>(mass, nullptr, shape.get(), inertia));
    shapes_.push_back(std::move(shape));
    btRigidBody& body = *bodies_.back();
    body.setWorldTransform(at(position));
    body.setActivationState(DISABLE_DEACTIVATION);
    body.setUserIndex(static_cast<int>(bodies_.size()) - 1);
    world_.addRigidBody(&body);
  }
  void remove(std::size_t index) {
    world_.removeRigidBody(bodies_[index].get());
    bodies_[index].reset();
  }
  void step() { world_.stepSimulation(1.0F / 60, 0); }
  [[nodiscard]] btDiscreteDynamicsWorld& world() { return world_; }
  [[nodiscard]] const auto& bodies() const { return bodies_; }

 private:
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

/// The pairs of which the narrow phase has a point that touches.
Touching touching(btCollisionWorld& world) {
  Touching found;
  for (int i = 0; i < world.getDispatcher()->getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *world.getDispatcher()->getManifoldByIndexInternal(i);
    for (int point = 0; point < manifold.getNumContacts(); ++point)
      if (manifold.getContactPoint(point).getDistance() <= 0)
        found.insert(std::minmax(manifold.getBody0()->getUserIndex(), manifold.getBody1()->getUserIndex()));
  }
  return found;
}

void add_floor_and_stacks(BulletWorld& world) {
  world.add(std::make_unique<btBoxShape>(btVector3(30, 1, 30)), {0, -1, 0}, 0);
  world.add(std::make_unique<btStaticPlaneShape>(btVector3(0, 1, 0), -5.0F), {0, 0, 0}, 0);
  for (int stack = 0; stack < 6; ++stack)
    for (int layer = 0; layer < 8; ++layer)
      world.add(std::make_unique<btBoxShape>(btVector3(0.5F, 0.5F, 0.5F)),
                {3.0F * static_cast<float>(stack) - 8, 0.5F + static_cast<float>(layer), 0}, 1);
}

/// A ball that rolls into the stacks.
void add_ball(BulletWorld& world, Random& random) {
  world.add(std::make_unique<btSphereShape>(pick(random, 0.3, 0.7)),
            {pick(random, -10, 10), pick(random, 0.7, 8), pick(random, -8, 8)}, 2);
  world.bodies().back()->setLinearVelocity({pick(random, -6, 6), 0, pick(random, -6, 6)});
}

/// The same shapes at the same places in a world of Bullet's own, in which nothing moves by itself.
class Mirror {
 public:
  void follow(const BulletWorld& original) {
    copies_.resize(original.bodies().size());
    for (std::size_t i = 0; i < copies_.size(); ++i) {
      btRigidBody* const body = original.bodies()[i].get();
      if (body == nullptr && copies_[i]) {
        world_.removeCollisionObject(copies_[i].get());
        copies_[i].reset();
      }
      if (body == nullptr) continue;
      if (!copies_[i]) copies_[i] = copy(*body);
      copies_[i]->setWorldTransform(body->getWorldTransform());
    }
    world_.performDiscreteCollisionDetection();
  }
  ~Mirror() {
    for (const auto& object : copies_)
      if (object) world_.removeCollisionObject(object.get());
  }
  Mirror() = default;
  Mirror(const Mirror&) = delete;
  Mirror& operator=(const Mirror&) = delete;
  [[nodiscard]] btCollisionWorld& world() { return world_; }

 private:
  std::unique_ptr<btCollisionObject> copy(btRigidBody& body) {
    auto object = std::make_unique<btCollisionObject>();
    object->setCollisionShape(body.getCollisionShape());
    object->setUserIndex(body.getUserIndex());
    object->setWorldTransform(body.getWorldTransform());
    const btBroadphaseProxy& proxy = *body.getBroadphaseProxy();
    world_.addCollisionObject(object.get(), proxy.m_collisionFilterGroup, proxy.m_collisionFilterMask);
    return object;
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broad_phase_;
  btCollisionWorld world_{&dispatcher_, &broad_phase_, &configuration_};
  std::vector<std::unique_ptr<btCollisionObject>> copies_;
};

TEST(BulletBroadPhase, ContactsAreThoseOfBulletsOwnWhileObjectsComeAndGo) {
  BulletBroadPhase broad_phase;
  BulletWorld world(broad_phase);
  Mirror mirror;
  add_floor_and_stacks(world);
  Random random(3);
  std::size_t most = 0;
  for (int step = 0; step < 600; ++step) {
    if (step % 5 == 0) add_ball(world, random);
    if (step % 7 == 3) {
      const auto gone = 2 + random.below(static_cast<std::uint32_t>(world.bodies().size()) - 2);
      if (world.bodies()[gone]) world.remove(gone);
    }
    mirror.follow(world);
    world.step();
    const Touching found = touching(world.world());
    ASSERT_EQ(found, touching(mirror.world())) << "step " << step;
    most = std::max(most, found.size());
  }
  EXPECT_GT(most, 60U);
}

// btSimpleBroadphase finds exactly the boxes that overlap, too, and the pairs are sorted: all of Bullet then
// computes the same bits.
TEST(BulletBroadPhase, TrajectoriesAreThoseOfAllPairsBitForBit) {
  BulletBroadPhase ours;
  btSimpleBroadphase theirs;
  BulletWorld first(ours);
  BulletWorld second(theirs);
  for (BulletWorld* world : {&first, &second}) add_floor_and_stacks(*world);
  Random random(4);
  for (int step = 0; step < 500; ++step) {
    if (step < 200 && step % 4 == 0) {
      Random same = random;
      add_ball(first, random);
      add_ball(second, same);
    }
    if (step > 200 && step % 20 == 0)
      for (BulletWorld* world : {&first, &second}) world->remove(static_cast<std::size_t>(step) / 10);
    first.step();
    second.step();
    for (std::size_t i = 0; i < first.bodies().size(); ++i) {
      if (!first.bodies()[i]) continue;
      const btVector3 here = first.bodies()[i]->getWorldTransform().getOrigin();
      const btVector3 there = second.bodies()[i]->getWorldTransform().getOrigin();
      ASSERT_EQ(std::memcmp(&here, &there, 3 * sizeof(btScalar)), 0) << "body " << i << ", step " << step;
    }
  }
}

TEST(BulletBroadPhase, TheCacheHasExactlyThePairsThatOverlapWhateverComesAndGoes) {
  BulletBroadPhase broad_phase;
  std::vector<btBroadphaseProxy*> proxies;
  Random random(5);
  const auto box = [&](btVector3& min, btVector3& max) {
    min = {pick(random, 0, 9), pick(random, 0, 9), pick(random, 0, 9)};
    max = min + btVector3(1, 1, 1);
  };
  for (int step = 0; step < 300; ++step) {
    btVector3 min;
    btVector3 max;
    for (int k = 0; k < 3; ++k) {
      box(min, max);
      const int group = k == 0 ? btBroadphaseProxy::StaticFilter : btBroadphaseProxy::DefaultFilter;
      const int mask = k == 0 ? ~btBroadphaseProxy::StaticFilter : ~0;
      proxies.push_back(broad_phase.createProxy(min, max, 0, nullptr, group, mask, nullptr));
    }
    for (int k = 0; k < 2 && proxies.size() > 100; ++k) {
      const std::size_t gone = random.below(static_cast<std::uint32_t>(proxies.size()));
      broad_phase.destroyProxy(proxies[gone], nullptr);
      proxies.erase(proxies.begin() + static_cast<std::ptrdiff_t>(gone));
    }
    for (std::size_t k = 0; k < proxies.size(); k += 3) {
      box(min, max);
      broad_phase.setAabb(proxies[k], min, max, nullptr);
    }
    broad_phase.calculateOverlappingPairs(nullptr);
    btOverlappingPairCache& cache = *broad_phase.getOverlappingPairCache();
    int expected = 0;
    for (std::size_t a = 0; a < proxies.size(); ++a)
      for (std::size_t b = a + 1; b < proxies.size(); ++b) {
        const bool pair = cache.needsBroadphaseCollision(proxies[a], proxies[b]) &&
                          TestAabbAgainstAabb2(proxies[a]->m_aabbMin, proxies[a]->m_aabbMax,
                                               proxies[b]->m_aabbMin, proxies[b]->m_aabbMax);
        expected += pair ? 1 : 0;
        ASSERT_EQ(cache.findPair(proxies[a], proxies[b]) != nullptr, pair) << step;
      }
    ASSERT_EQ(cache.getNumOverlappingPairs(), expected);
  }
  for (btBroadphaseProxy* proxy : proxies) broad_phase.destroyProxy(proxy, nullptr);
  EXPECT_EQ(broad_phase.getOverlappingPairCache()->getNumOverlappingPairs(), 0);
}

TEST(BulletBroadPhase, RaysAndSweepsHitWhatTheyHitWithBulletsOwn) {
  BulletBroadPhase ours;
  btDbvtBroadphase theirs;
  BulletWorld first(ours);
  BulletWorld second(theirs);
  Random random(6);
  for (BulletWorld* world : {&first, &second}) add_floor_and_stacks(*world);
  for (int i = 0; i < 60; ++i) {
    Random same = random;
    add_ball(first, random);
    add_ball(second, same);
  }
  btSphereShape probe(0.4F);
  int hits = 0;
  for (int i = 0; i < 300; ++i) {
    const btVector3 from(pick(random, -12, 12), pick(random, -2, 9), pick(random, -9, 9));
    const btVector3 to(pick(random, -12, 12), pick(random, -2, 9), pick(random, -9, 9));
    std::vector<float> fractions;
    for (BulletWorld* world : {&first, &second}) {
      btCollisionWorld::ClosestRayResultCallback ray(from, to);
      world->world().rayTest(from, to, ray);
      btCollisionWorld::ClosestConvexResultCallback sweep(from, to);
      world->world().convexSweepTest(&probe, at(from), at(to), sweep);
      fractions.insert(fractions.end(), {ray.m_closestHitFraction, sweep.m_closestHitFraction});
    }
    ASSERT_EQ(fractions[0], fractions[2]);
    ASSERT_EQ(fractions[1], fractions[3]);
    hits += fractions[0] < 1 ? 1 : 0;
  }
  EXPECT_GT(hits, 100);
}

struct Collector final : btBroadphaseAabbCallback {
  bool process(const btBroadphaseProxy* proxy) override {
    found.push_back(proxy);
    return found.size() < limit;
  }
  std::size_t limit = SIZE_MAX;
  std::vector<const btBroadphaseProxy*> found;
};

TEST(BulletBroadPhase, ABoxFindsWhatOverlapsItUntilTheCallbackEndsIt) {
  BulletBroadPhase broad_phase;
  std::vector<btBroadphaseProxy*> row;
  for (int i = 0; i < 5; ++i) {
    const btVector3 min(2.0F * static_cast<float>(i), 0, 0);
    row.push_back(broad_phase.createProxy(min, min + btVector3(1, 1, 1), 0, nullptr, 1, -1, nullptr));
  }
  Collector all;
  broad_phase.aabbTest({3, 0, 0}, {6, 1, 1}, all);  // touches the first and the last with its faces
  EXPECT_THAT(all.found, testing::UnorderedElementsAre(row[1], row[2], row[3]));
  Collector one;
  one.limit = 1;
  broad_phase.aabbTest({0, 0, 0}, {9, 1, 1}, one);
  EXPECT_EQ(one.found.size(), 1U);
  btVector3 min;
  btVector3 max;
  broad_phase.getBroadphaseAabb(min, max);
  EXPECT_EQ(max, btVector3(9, 1, 1));
  broad_phase.setAabb(row[4], {0, 0, 0}, {1, 1, 1}, nullptr);  // a query sees the latest boxes
  Collector moved;
  broad_phase.aabbTest({8, 0, 0}, {9, 1, 1}, moved);
  EXPECT_TRUE(moved.found.empty());
  for (btBroadphaseProxy* proxy : row) broad_phase.destroyProxy(proxy, nullptr);
  broad_phase.resetPool(nullptr);
  EXPECT_EQ(broad_phase.createProxy({0, 0, 0}, {1, 1, 1}, 0, nullptr, 1, -1, nullptr)->m_uniqueId, 1);
}

struct RayCollector final : btBroadphaseRayCallback {
  RayCollector(const btVector3& from, const btVector3& to) {
    const btVector3 way = to - from;
    for (int i = 0; i < 3; ++i) {
      m_rayDirectionInverse[i] = way[i] == 0 ? BT_LARGE_FLOAT : 1 / way[i];
      m_signs[i] = m_rayDirectionInverse[i] < 0 ? 1U : 0U;
    }
    m_lambda_max = 1;
  }
  bool process(const btBroadphaseProxy* proxy) override {
    found.push_back(proxy);
    return true;
  }
  std::vector<const btBroadphaseProxy*> found;
};

TEST(BulletBroadPhase, QueriesFindWhatALookAtEachFindsWhileProxiesComeMoveAndGo) {
  BulletBroadPhase broad_phase;
  std::vector<btBroadphaseProxy*> proxies;
  Random random(12);
  const auto anywhere = [&random] {
    return btVector3(pick(random, 0, 9), pick(random, 0, 9), pick(random, 0, 9));
  };
  const btVector3 size(0.5F, 0.5F, 0.5F);
  std::size_t hits = 0;
  for (int k = 0; k < 1500; ++k) {
    const int changes = k / 100 % 3 == 0 ? 0 : k % 60 + 1;  // none, few, and more than pay to pack
    for (int c = 0; c < changes; ++c) {
      const btVector3 min = anywhere();
      const std::size_t i = random.below(200);
      if (i >= proxies.size()) {
        proxies.push_back(broad_phase.createProxy(min, min + size, 0, nullptr, 1, -1, nullptr));
      } else if (random.below(4) == 0) {
        broad_phase.destroyProxy(proxies[i], nullptr);
        proxies.erase(proxies.begin() + static_cast<std::ptrdiff_t>(i));
      } else {
        broad_phase.setAabb(proxies[i], min, min + size, nullptr);
      }
    }
    const btVector3 from = anywhere();
    const btVector3 half = random.below(2) == 0 ? btVector3(0, 0, 0) : size;
    btVector3 to = random.below(4) == 0 ? from : anywhere();
    if (!proxies.empty() && random.below(2) == 0)  // past a corner of a box
      to = from +
           2 * (proxies[random.below(static_cast<std::uint32_t>(proxies.size()))]->m_aabbMax + half - from);
    const btVector3 aside = random.below(3) == 0 ? btVector3(1e4F, -1e4F, 1e4F) : btVector3(0, 0, 0);
    RayCollector ray(from, to);  // of a shape that may lie far from its own origin
    broad_phase.rayTest(from - aside, to - aside, ray, aside - half, aside + half);
    const btVector3 min = anywhere();
    Collector box;
    broad_phase.aabbTest(min, min + size, box);
    std::vector<const btBroadphaseProxy*> on_way;
    std::vector<const btBroadphaseProxy*> near;
    for (const btBroadphaseProxy* proxy : proxies) {
      const btVector3 bounds[2] = {proxy->m_aabbMin - (aside + half), proxy->m_aabbMax - (aside - half)};
      btScalar entry = 1;
      if (btRayAabb2(from - aside, ray.m_rayDirectionInverse, ray.m_signs, bounds, entry, 0, 1))
        on_way.push_back(proxy);
      if (TestAabbAgainstAabb2(min, min + size, proxy->m_aabbMin, proxy->m_aabbMax)) near.push_back(proxy);
    }
    ASSERT_THAT(ray.found, testing::UnorderedElementsAreArray(on_way)) << k;
    ASSERT_THAT(box.found, testing::UnorderedElementsAreArray(near)) << k;
    hits += on_way.size() + near.size();
  }
  EXPECT_GT(hits, 1000U);
  for (btBroadphaseProxy* proxy : proxies) broad_phase.destroyProxy(proxy, nullptr);
}

TEST(BulletBroadPhase, GhostObjectsKnowWhatOverlapsThem) {
  BulletBroadPhase broad_phase;
  btGhostPairCallback callback;
  BulletWorld world(broad_phase);
  broad_phase.getOverlappingPairCache()->setInternalGhostPairCallback(&callback);
  btBoxShape room(btVector3(1, 1, 1));
  btPairCachingGhostObject ghost;
  ghost.setCollisionShape(&room);
  ghost.setCollisionFlags(btCollisionObject::CF_NO_CONTACT_RESPONSE);
  world.world().addCollisionObject(&ghost, btBroadphaseProxy::SensorTrigger, btBroadphaseProxy::AllFilter);
  world.add(std::make_unique<btSphereShape>(0.5F), {0, 5, 0}, 1);
  std::vector<int> seen;
  for (int step = 0; step < 200; ++step) {
    world.step();
    if (seen.empty() || seen.back() != ghost.getNumOverlappingObjects())
      seen.push_back(ghost.getNumOverlappingObjects());
  }
  EXPECT_THAT(seen, testing::ElementsAre(0, 1, 0));  // the ball falls through
  world.world().removeCollisionObject(&ghost);
}

TEST(BulletBroadPhase, ACacheThatDefersRemovalsIsRefused) {
  btSortedOverlappingPairCache cache;
  EXPECT_THROW(BulletBroadPhase({}, &cache), std::invalid_argument);
}

}  // namespace
}  // namespace kerf
