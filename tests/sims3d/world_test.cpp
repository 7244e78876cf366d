#include "sims3d/world.h"

#include <gmock/gmock.h>

#include <limits>
#include <thread>

#include "core/base/random.h"
#include "core/broad_phase/brute_force.h"
#include "tests/sims3d/test_broad_phases.h"

namespace kerf {
namespace {

using sims3d_test::Disorderly;
using sims3d_test::Everything;
using sims3d_test::Inventive;
using sims3d_test::Seam;
using sims3d_test::Silent;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::SizeIs;

const Shape<3> kBall = Ball{0.5F};
const Shape<3> kCube = Brick<3>{{{0.5F, 0.5F, 0.5F}}};
const Shape<3> kFloor = Brick<3>{{{90, 0.5F, 90}}};

/// A fixed floor with its top at y = 0.
ObjectId add_floor(OdeWorld& world) { return world.add_fixed(kFloor, {{0, -0.5F, 0}}); }

Pose<3> at(float x, float y, float z) { return {.position = {{x, y, z}}}; }

/// A floor and a cloud of balls and bricks above it that overlap each other here and there.
void add_cloud(OdeWorld& world, std::uint64_t seed) {
  add_floor(world);
  Random random(seed);
  for (int i = 0; i < 60; ++i) {
    Pose<3> pose;
    for (int axis = 0; axis < 3; ++axis)
      pose.position[axis] = static_cast<Scalar>(random.uniform(axis == 1 ? 1 : -2, axis == 1 ? 9 : 2));
    world.add_moving(i % 2 == 0 ? kBall : kCube, pose, {{{0, -2, 0}}, {{1, 2, 3}}});
  }
}

std::vector<Vector<3>> positions(const OdeWorld& world) {
  std::vector<Vector<3>> list;
  for (const Body<3>& body : world.bodies()) list.push_back(body.pose.position);
  return list;
}

std::vector<Pair> contacts(const OdeWorld& world) {
  return {world.contacts().begin(), world.contacts().end()};
}

void advance(OdeWorld& world, int steps) {
  for (int i = 0; i < steps; ++i) world.advance();
}

TEST(OdeWorld, BodiesAreShownAtThePosesThatTheBroadPhaseSaw) {
  BruteForce<3> broad_phase;
  OdeWorld world(broad_phase, 1);
  const ObjectId ball = world.add_moving(kBall, at(1, 5, 2), {{{0, -1, 0}}, {}});
  world.advance();
  EXPECT_EQ(world.step(), 1U);
  EXPECT_EQ(world.bodies()[ball.index()].pose.position, (Vector<3>{{1, 5, 2}}));
  world.advance();
  EXPECT_LT(world.bodies()[ball.index()].pose.position[1], 5);
}

TEST(OdeWorld, FallsAsNewtonSays) {
  BruteForce<3> broad_phase;
  OdeWorld world(broad_phase, 1);
  world.add_moving(kBall, at(0, 50, 0), {});
  advance(world, 11);  // ten steps of dynamics are seen: 0.4 s
  EXPECT_NEAR(world.bodies()[0].pose.position[1], 50 - 0.5 * 9.81 * 0.4 * 0.4, 0.1);
}

TEST(OdeWorld, NothingFallsFurtherInAStepThanTheSmallestHalfExtent) {
  BruteForce<3> broad_phase;
  OdeWorld world(broad_phase, 1);
  world.add_moving(kBall, at(0, 50, 0), {});
  advance(world, 60);
  const float before = world.bodies()[0].pose.position[1];
  world.advance();
  EXPECT_NEAR(before - world.bodies()[0].pose.position[1], 0.35, 1e-3);
}

TEST(OdeWorld, SilentBroadPhaseGivesNoContact) {
  Silent silent;
  OdeWorld world(silent, 1);
  add_cloud(world, 3);
  for (int i = 0; i < 60; ++i) {
    world.advance();
    ASSERT_THAT(world.contacts(), IsEmpty());
  }
  for (std::size_t i = 1; i < world.bodies().size(); ++i)
    EXPECT_LT(world.bodies()[i].pose.position[1], -1) << "object " << i << " was stopped";
}

TEST(OdeWorld, ContactsEqualThoseOfAllPairs) {
  BruteForce<3> oracle;
  Everything everything;
  OdeWorld world(oracle, 1);
  OdeWorld other(everything, 1);
  add_cloud(world, 3);
  add_cloud(other, 3);
  for (int i = 0; i < 200; ++i) {
    world.advance();
    other.advance();
    ASSERT_EQ(contacts(world), contacts(other)) << "step " << world.step();
    ASSERT_EQ(positions(world), positions(other)) << "step " << world.step();
  }
  EXPECT_THAT(world.contacts(), SizeIs(testing::Gt(60U)));
}

TEST(OdeWorld, OrderAndRepetitionOfPairsChangeNothing) {
  BruteForce<3> orderly;
  Disorderly disorderly;
  OdeWorld world(orderly, 1);
  OdeWorld other(disorderly, 1);
  add_cloud(world, 4);
  add_cloud(other, 4);
  for (int i = 0; i < 150; ++i) {
    world.advance();
    other.advance();
    ASSERT_EQ(positions(world), positions(other)) << "step " << world.step();
  }
  EXPECT_EQ(contacts(world), contacts(other));
}

TEST(OdeWorld, AnotherSolverSeedIsAnotherRun) {
  BruteForce<3> first;
  BruteForce<3> second;
  OdeWorld world(first, 1);
  OdeWorld other(second, 2);
  add_cloud(world, 3);
  add_cloud(other, 3);
  advance(world, 100);
  advance(other, 100);
  EXPECT_NE(positions(world), positions(other));
}

std::vector<Vector<3>> run_alone() {
  BruteForce<3> broad_phase;
  OdeWorld world(broad_phase, 1);
  add_cloud(world, 3);
  advance(world, 120);
  return positions(world);
}

TEST(OdeWorld, SeveralAtOnceDoNotDisturbEachOther) {
  const std::vector<Vector<3>> alone = run_alone();
  BruteForce<3> first;
  BruteForce<3> second;
  OdeWorld world(first, 1);
  OdeWorld other(second, 7);
  add_cloud(world, 3);
  add_cloud(other, 5);
  for (int i = 0; i < 120; ++i) {
    world.advance();
    other.advance();
  }
  EXPECT_EQ(positions(world), alone);
}

TEST(OdeWorld, ThreadsDoNotDisturbEachOther) {
  const std::vector<Vector<3>> alone = run_alone();
  std::vector<std::vector<Vector<3>>> runs(3);
  std::vector<std::thread> threads;
  threads.reserve(runs.size());
  for (auto& run : runs) threads.emplace_back([&run] { run = run_alone(); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& run : runs) EXPECT_EQ(run, alone);
}

TEST(OdeWorld, FixedObjectsAreGivenOnceAndSleepersAreNotMoved) {
  Seam seam;
  OdeWorld world(seam, 1);
  add_cloud(world, 3);
  EXPECT_THAT(seam.fixed, ElementsAre(ObjectId{0}));
  advance(world, 600);
  EXPECT_EQ(seam.inserted, 61U);
  EXPECT_EQ(std::count(seam.moved.begin(), seam.moved.end(), ObjectId{0}), 0);
  ASSERT_EQ(world.awake(), 0U);
  world.advance();  // shows the last moves
  seam.moved.clear();
  const std::vector<Pair> resting = contacts(world);
  world.advance();
  EXPECT_THAT(seam.moved, IsEmpty());
  EXPECT_EQ(contacts(world), resting);
  EXPECT_THAT(resting, testing::Not(IsEmpty()));
}

/// A cube on a floor and one upon it, both asleep.
struct Tower {
  Seam broad_phase;
  OdeWorld world{broad_phase, 1};
  ObjectId floor = add_floor(world);
  ObjectId lower = world.add_moving(kCube, at(0, 0.5F, 0), {});
  ObjectId upper = world.add_moving(kCube, at(0, 1.5F, 0), {});
  Tower() { advance(world, 60); }
};

TEST(OdeWorld, SleepersStillTouch) {
  Tower tower;
  EXPECT_EQ(tower.world.awake(), 0U);
  EXPECT_THAT(tower.world.contacts(),
              ElementsAre(Pair{tower.floor, tower.lower}, Pair{tower.lower, tower.upper}));
}

TEST(OdeWorld, ASoftTouchDoesNotWakeTheSleeper) {
  Tower tower;
  tower.world.add_moving(kBall, at(0, 2.5F, 0), {});
  tower.broad_phase.moved.clear();
  advance(tower.world, 6);
  EXPECT_EQ(tower.world.awake(), 1U);
  EXPECT_THAT(tower.world.contacts(), SizeIs(3));
  EXPECT_THAT(tower.broad_phase.moved, testing::Each(ObjectId{3}));
}

TEST(OdeWorld, AHitWakesTheSleeper) {
  Tower tower;
  const ObjectId ball = tower.world.add_moving(kBall, at(-3, 0.5F, 0), {{{8, 0, 0}}, {}});
  advance(tower.world, 15);
  EXPECT_GT(tower.world.bodies()[tower.lower.index()].pose.position[0], 0.05F);
  EXPECT_GT(tower.world.awake(), 0U);
  EXPECT_THAT(ball.value, 3U);
}

TEST(OdeWorld, ASleeperWakesWhenItsSupportIsTakenAway) {
  Tower tower;
  tower.world.place(tower.lower, {{8, 0.5F, 0}}, {});
  advance(tower.world, 40);
  EXPECT_NEAR(tower.world.bodies()[tower.upper.index()].pose.position[1], 0.5F, 0.05F);
}

TEST(OdeWorld, ABoxThatDidNotChangeIsNotMoved) {
  Seam seam;
  WorldSettings weightless;
  weightless.gravity = 0;
  weightless.sleep.allowed = false;
  OdeWorld world(seam, 1, weightless);
  world.add_moving(kCube, at(0, 0, 0), {});
  world.add_moving(kCube, at(5, 0, 0), {{{1, 0, 0}}, {}});
  advance(world, 5);
  EXPECT_EQ(world.awake(), 2U);
  EXPECT_THAT(seam.moved, ElementsAre(ObjectId{1}, ObjectId{1}, ObjectId{1}, ObjectId{1}));
}

TEST(OdeWorld, WithoutSleepEverythingStaysAwake) {
  BruteForce<3> broad_phase;
  WorldSettings settings;
  settings.sleep.allowed = false;
  OdeWorld world(broad_phase, 1, settings);
  add_floor(world);
  world.add_moving(kCube, at(0, 0.5F, 0), {});
  advance(world, 100);
  EXPECT_EQ(world.awake(), 1U);
}

/// The message of the std::runtime_error that advancing throws, "" if it throws none.
std::string error_of_advance(OdeWorld& world) {
  try {
    advance(world, 5);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(OdeWorld, APoseThatIsNotFiniteIsAnErrorThatNamesTheObject) {
  BruteForce<3> broad_phase;
  OdeWorld world(broad_phase, 1);
  add_floor(world);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  world.add_moving(kBall, at(0, 3, 0), {{{nan, 0, 0}}, {}});
  EXPECT_THAT(error_of_advance(world), HasSubstr("object 1 has no finite pose after step 1"));
}

TEST(OdeWorld, AnInventedObjectIsAnErrorThatNamesThePair) {
  Inventive inventive;
  OdeWorld world(inventive, 1);
  add_floor(world);
  inventive.extra = {{0}, {77}};
  EXPECT_THAT(error_of_advance(world), HasSubstr("gives the pair 0, 77"));
  inventive.extra = {{0}, {0}};
  EXPECT_THAT(error_of_advance(world), HasSubstr("gives the pair 0, 0"));
}

TEST(OdeWorld, AFalseCandidateIsNoContact) {
  Inventive inventive;
  OdeWorld world(inventive, 1);
  add_floor(world);
  world.add_moving(kBall, at(0, 8, 0), {});
  inventive.extra = {{0}, {1}};
  world.advance();
  EXPECT_THAT(world.pairs(), IsSupersetOf({inventive.extra}));
  EXPECT_THAT(world.contacts(), IsEmpty());
}

TEST(OdeWorld, ABroadPhaseInUseIsRefused) {
  BruteForce<3> broad_phase;
  ASSERT_EQ(broad_phase.insert({0}, Box<3>{}, Mobility::fixed), Status::ok);
  OdeWorld world(broad_phase, 1);
  EXPECT_THROW(add_floor(world), std::runtime_error);
}

TEST(OdeWorld, ShapesWithoutSizeAreRefused) {
  BruteForce<3> broad_phase;
  OdeWorld world(broad_phase, 1);
  EXPECT_THROW(world.add_moving(Ball{0}, {}, {}), std::invalid_argument);
  EXPECT_THROW(world.add_moving(Brick<3>{{{1, -1, 1}}}, {}, {}), std::invalid_argument);
  EXPECT_THROW(world.add_fixed(std::shared_ptr<const Surface>(), {}), std::invalid_argument);
  const Surface bad{{{{0, 0, 0}}, {{1, 0, 0}}}, {{0, 1, 2}}};
  EXPECT_THROW(world.add_fixed(std::make_shared<const Surface>(bad), {}), std::invalid_argument);
  EXPECT_THAT(world.bodies(), IsEmpty());
}

TEST(OdeWorld, OnlyMovingObjectsCanBePlaced) {
  BruteForce<3> broad_phase;
  OdeWorld world(broad_phase, 1);
  const ObjectId floor = add_floor(world);
  EXPECT_THROW(world.place(floor, {}, {}), std::invalid_argument);
  EXPECT_THROW(world.place({5}, {}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace kerf
