// Each allocation that an adapter makes for a new object fails once. The object is here then or it is not,
// and pairs are those of the objects that are here.

#include <box2d/box2d.h>
#include <btBulletDynamicsCommon.h>
#include <fcl/fcl.h>
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

#include "sims2d/box2d/box2d_broad_phase.h"
#include "sims3d/bullet/bullet_broad_phase.h"
#include "sims3d/fcl/fcl_manager.h"
#include "sims3d/ode/ode_geoms.h"

namespace {

long left = -1;  ///< allocations until one fails; negative: none does

void* allocate(std::size_t size, std::size_t alignment) {
  const bool is_denied = left == 0;
  if (left >= 0) --left;
  void* const memory =
      is_denied ? nullptr : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (memory == nullptr && size > 0) throw std::bad_alloc();
  return memory;
}

}  // namespace

// GCC takes an inlined free for a mismatch.
#define KERF_OUT_OF_LINE __attribute__((noinline))
void* operator new(std::size_t size) { return allocate(size == 0 ? 1 : size, 16); }
void* operator new[](std::size_t size) { return allocate(size == 0 ? 1 : size, 16); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate(size == 0 ? 1 : size, static_cast<std::size_t>(alignment));
}
KERF_OUT_OF_LINE void operator delete(void* memory) noexcept { std::free(memory); }
KERF_OUT_OF_LINE void operator delete[](void* memory) noexcept { std::free(memory); }
KERF_OUT_OF_LINE void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
KERF_OUT_OF_LINE void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
KERF_OUT_OF_LINE void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
KERF_OUT_OF_LINE void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}
#undef KERF_OUT_OF_LINE

namespace kerf {
namespace {

constexpr int kObjects = 33;  // after a power of two lists grow

/// Calls `add` while that allocation fails; negative: none. Whether it did.
template <class Add>
bool fails(long allocation, const Add& add) {
  left = allocation;
  bool failed = false;
  try {
    add();
  } catch (const std::bad_alloc&) {
    failed = true;
  }
  left = -1;
  return failed;
}

/// `attempt(allocation)` makes kObjects objects that all meet, the last while that allocation fails, expects
/// the pairs, and returns whether it failed.
template <class Attempt>
void expect_no_orphans(const Attempt& attempt) {
  long allocation = 0;
  while (attempt(allocation)) ++allocation;
  EXPECT_GT(allocation, 2);
}

int pairs_among(std::size_t objects) { return static_cast<int>(objects * (objects - 1) / 2); }

using Object = fcl::CollisionObject<double>;

bool count_objects(Object* /*a*/, Object* /*b*/, void* data) {
  ++*static_cast<int*>(data);
  return false;
}

TEST(AdaptersOutOfMemory, FclRegistersAnObjectOrDoesNot) {
  const auto sphere = std::make_shared<fcl::Sphere<double>>(0.5);
  expect_no_orphans([&](long allocation) {
    FclManager<double> manager;
    std::vector<std::unique_ptr<Object>> objects;
    bool failed = false;
    for (int k = 0; k < kObjects; ++k) {
      auto object = std::make_unique<Object>(sphere);
      object->setTranslation({0.01 * k, 0, 0});
      object->computeAABB();
      failed = fails(k + 1 < kObjects ? -1 : allocation, [&] { manager.registerObject(object.get()); });
      if (!failed) objects.push_back(std::move(object));
    }
    EXPECT_EQ(manager.size(), objects.size());
    manager.setup();
    int pairs = 0;
    manager.collide(&pairs, count_objects);
    EXPECT_EQ(pairs, pairs_among(objects.size())) << allocation;
    return failed;
  });
}

void count_geoms(void* data, dGeomID /*a*/, dGeomID /*b*/) { ++*static_cast<int*>(data); }

TEST(AdaptersOutOfMemory, OdeAddsAGeomOrDoesNot) {
  dInitODE2(0);
  expect_no_orphans([&](long allocation) {
    OdeGeoms geoms;
    std::vector<dGeomID> added;
    bool failed = false;
    for (int k = 0; k < kObjects; ++k) {
      const dGeomID geom = dCreateSphere(nullptr, 0.5);
      dGeomSetPosition(geom, 0.01 * k, 0, 0);
      failed = fails(k + 1 < kObjects ? -1 : allocation, [&] { geoms.add(geom); });
      if (failed) {
        dGeomDestroy(geom);
      } else {
        added.push_back(geom);
      }
    }
    EXPECT_EQ(geoms.size(), added.size());
    int pairs = 0;
    geoms.collide(&pairs, count_geoms);
    EXPECT_EQ(pairs, pairs_among(added.size())) << allocation;
    for (const dGeomID geom : added) dGeomDestroy(geom);
    return failed;
  });
  dCloseODE();
}

TEST(AdaptersOutOfMemory, BulletMakesAProxyOrDoesNot) {
  expect_no_orphans([&](long allocation) {
    BulletBroadPhase broad_phase;
    std::size_t made = 0;
    bool failed = false;
    for (int k = 0; k < kObjects; ++k) {
      const btScalar x = 0.01F * static_cast<btScalar>(k);
      failed = fails(k + 1 < kObjects ? -1 : allocation, [&] {
        broad_phase.createProxy({x, 0, 0}, {x + 1, 1, 1}, 0, nullptr, 1, -1, nullptr);
        ++made;
      });
    }
    broad_phase.calculateOverlappingPairs(nullptr);
    EXPECT_EQ(broad_phase.getOverlappingPairCache()->getNumOverlappingPairs(), pairs_among(made))
        << allocation;
    return failed;
  });
}

/// Its fixtures are Box2D's: the next update takes what one that failed has left, unless it is gone by then.
TEST(AdaptersOutOfMemory, Box2dTakesAFixtureInTheNextUpdate) {
  for (const bool goes : {false, true})
    expect_no_orphans([&](long allocation) {
      b2World world({0, 0});
      Box2dBroadPhase broad_phase(world);
      b2BodyDef def;
      def.type = b2_dynamicBody;
      b2CircleShape shape;
      shape.m_radius = 0.5F;
      b2Body* last = nullptr;
      int bodies = 0;
      for (; bodies < kObjects; ++bodies) {
        if (bodies + 1 == kObjects) broad_phase.update(1.0F / 60);
        def.position.Set(0.01F * static_cast<float>(bodies), 0);
        last = world.CreateBody(&def);
        last->CreateFixture(&shape, 1);
      }
      const bool failed = fails(allocation, [&] { broad_phase.update(1.0F / 60); });
      if (goes) {
        world.DestroyBody(last);
        --bodies;
      }
      broad_phase.update(1.0F / 60);
      EXPECT_EQ(world.GetContactCount(), pairs_among(static_cast<std::size_t>(bodies))) << allocation;
      return failed;
    });
}

}  // namespace
}  // namespace kerf
