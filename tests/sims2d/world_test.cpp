#include "sims2d/world.h"

#include <box2d/box2d.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "core/broad_phase/brute_force.h"
#include "sims2d/scenes/fixed.h"
#include "tests/sims2d/box2d_reference.h"
#include "tests/sims2d/broad_phase_doubles.h"
#include "tests/sims2d/shapes.h"

namespace kerf {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr Pair kFirstTwo{ObjectId{0}, ObjectId{1}};

BodyPlan moving(const Shape<2>& shape, Scalar x, Scalar y) {
  BodyPlan plan;
  plan.shape = shape;
  plan.position = {{x, y}};
  return plan;
}

/// The newest body; Box2D lists it first. Tests may push what the world only shows.
b2Body& newest(const Box2dWorld& world) { return const_cast<b2Body&>(*world.engine().GetBodyList()); }

/// A disc that lies on a floor, object 1 on object 0.
void add_disc_on_floor(Box2dWorld& world) {
  world.add(fixed_brick({{0, -0.5F}}, {{5, 0.5F}}));
  world.add(moving(Ball{0.5F}, 0, 0.5F));
}

TEST(Box2dWorld, ADiscComesToRestOnTheFloor) {
  BruteForce<2> broad_phase;
  Box2dWorld world(broad_phase);
  add_disc_on_floor(world);
  for (int i = 0; i < 100; ++i) world.advance();
  EXPECT_THAT(world.contacts(), ElementsAre(kFirstTwo));
  EXPECT_NEAR(world.bodies()[1].pose.position[1], 0.5F, 0.02F);
}

TEST(Box2dWorld, SilenceMeansNoContactAndFallingThrough) {
  test::SilentBroadPhase broad_phase;
  Box2dWorld world(broad_phase);
  add_disc_on_floor(world);
  for (int i = 0; i < 100; ++i) {
    world.advance();
    ASSERT_EQ(world.engine().GetContactCount(), 0);
  }
  EXPECT_LT(world.bodies()[1].pose.position[1], -5);
}

TEST(Box2dWorld, APairThatIsNoLongerReportedLosesItsContact) {
  BruteForce<2> inner;
  test::WatchedBroadPhase broad_phase(inner);
  Box2dWorld world(broad_phase);
  add_disc_on_floor(world);
  for (int i = 0; i < 10; ++i) world.advance();
  EXPECT_EQ(world.engine().GetContactCount(), 1);
  broad_phase.edit_pairs = [](std::vector<Pair>& pairs) { pairs.clear(); };
  world.advance();
  EXPECT_EQ(world.engine().GetContactCount(), 0);
  EXPECT_THAT(world.contacts(), IsEmpty());
}

TEST(Box2dWorld, BodiesStandWhereTheNarrowPhaseSawThem) {
  BruteForce<2> inner;
  test::WatchedBroadPhase broad_phase(inner);
  Box2dWorld world(broad_phase);
  world.add(moving(Ball{0.5F}, 0, 10));
  b2Vec2 seen;
  broad_phase.before_step = [&] { seen = newest(world).GetPosition(); };
  for (int i = 0; i < 5; ++i) {
    world.advance();
    EXPECT_EQ(world.bodies()[0].pose.position, (Vector<2>{{seen.x, seen.y}}));
    EXPECT_NE(newest(world).GetPosition().y, seen.y) << "the engine has gone on";
  }
}

TEST(Box2dWorld, FixedAndSleepingBodiesAreNotMovedInTheBroadPhase) {
  BruteForce<2> inner;
  test::WatchedBroadPhase broad_phase(inner);
  Box2dWorld world(broad_phase);
  add_disc_on_floor(world);
  EXPECT_THAT(broad_phase.inserted, ElementsAre(Mobility::fixed, Mobility::moving));
  for (int i = 0; i < 200; ++i) world.advance();
  ASSERT_FALSE(newest(world).IsAwake());
  EXPECT_THAT(broad_phase.moved, ::testing::Each(ObjectId{1}));
  broad_phase.moved.clear();
  for (int i = 0; i < 20; ++i) world.advance();
  EXPECT_THAT(broad_phase.moved, IsEmpty());
  EXPECT_THAT(world.contacts(), ElementsAre(kFirstTwo)) << "a sleeping contact is a contact";
}

// Two corners meet tip to tip at 0.026, where the narrow phase says "touch", while Box2D's fat boxes are used
// up and do not overlap: without a new proxy Box2D would destroy the contact unseen.
TEST(Box2dWorld, ATouchBeyondTheFatBoxesIsAContact) {
  BruteForce<2> broad_phase;
  Box2dWorld world(broad_phase);
  const Scalar start = 0.513F + 0.099F;
  world.add(moving(test::diamond(), -start, 0));
  b2Body& left = newest(world);
  world.add(moving(test::diamond(), start, 0));
  left.SetTransform(b2Vec2(-0.513F, 0), 0);
  newest(world).SetTransform(b2Vec2(0.513F, 0), 0);
  ASSERT_THAT(test::box2d_contacts(world.engine()).touching, ElementsAre(kFirstTwo));
  world.advance();
  EXPECT_THAT(world.contacts(), ElementsAre(kFirstTwo));
}

TEST(Box2dWorld, RefusesABroadPhaseThatHoldsObjectsAlready) {
  BruteForce<2> broad_phase;
  EXPECT_EQ(broad_phase.insert(ObjectId{0}, Box<2>{}, Mobility::moving), Status::ok);
  Box2dWorld world(broad_phase);
  EXPECT_THROW(world.add(moving(Ball{0.5F}, 0, 0)), std::runtime_error);
  EXPECT_EQ(world.engine().GetBodyCount(), 0) << "nothing half-added";
}

TEST(Box2dWorld, RefusesPosesThatAreNotFinite) {
  BruteForce<2> broad_phase;
  Box2dWorld world(broad_phase);
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_THROW(world.add(moving(Ball{0.5F}, infinity, 0)), std::invalid_argument);
  BodyPlan spinning = moving(Ball{0.5F}, 0, 0);
  spinning.spin = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(world.add(spinning), std::invalid_argument);
}

TEST(Box2dWorld, ABodyThatLeavesTheFiniteIsNamed) {
  test::SilentBroadPhase broad_phase;
  Box2dWorld world(broad_phase);
  add_disc_on_floor(world);
  world.advance();
  newest(world).SetLinearVelocity(b2Vec2(std::numeric_limits<float>::quiet_NaN(), 0));
  world.advance();
  try {
    world.advance();
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "the pose of object 1 is not finite at step 3");
  }
}

TEST(Box2dWorld, RefusesPairsOfUnknownObjects) {
  BruteForce<2> inner;
  test::WatchedBroadPhase broad_phase(inner);
  Box2dWorld world(broad_phase);
  add_disc_on_floor(world);
  broad_phase.edit_pairs = [](std::vector<Pair>& pairs) { pairs = {{ObjectId{0}, ObjectId{7}}}; };
  EXPECT_THROW(world.advance(), std::runtime_error);
  broad_phase.edit_pairs = [](std::vector<Pair>& pairs) { pairs = {{ObjectId{1}, ObjectId{1}}}; };
  EXPECT_THROW(world.advance(), std::runtime_error);
}

}  // namespace
}  // namespace kerf
