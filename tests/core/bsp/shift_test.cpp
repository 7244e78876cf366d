// Worlds whose origin is moved while pairs are kept, or while leaves are swept.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/bsp/bsp.h"
#include "core/bsp/bsp_state.h"
#include "core/replay/oracle.h"
#include "core/tree/validate.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/pairs.h"

namespace kerf::test {
namespace {

Config leaves_of_32() {
  Config config = tuned_config();
  config.min_threshold = config.max_threshold = 32;
  return config;
}

/// Objects of which a share moves a little in each step.
template <int D>
class ShiftedWorld {
 public:
  static constexpr std::uint32_t kCount = 600;

  ShiftedWorld(double moving, double reach) : moving_(moving), reach_(reach) {
    for (std::uint32_t id = 0; id < kCount; ++id) {
      ids_.push_back({id});
      boxes_.push_back(random_box<D>(random_, 10, 0.5));
      EXPECT_EQ(tree_.insert({id}, boxes_[id], id % 8 == 0 ? Mobility::fixed : Mobility::moving), Status::ok);
    }
    tree_.step();
  }

  /// One step, in which everything moves by the vector, too, and one object to the place of another.
  void step(const Vector<D>& by = {}, std::optional<std::pair<std::uint32_t, std::uint32_t>> jump = {}) {
    for (std::uint32_t id = 0; id < ids_.size(); ++id) {
      const bool moves = id % 8 != 0 && random_.uniform(0, 1) < moving_;
      const Vector<D> way = moves ? random_point<D>(random_, -reach_, reach_) + by : by;
      boxes_[id] = {boxes_[id].min + way, boxes_[id].max + way};
    }
    if (jump) boxes_[jump->first] = boxes_[jump->second];
    EXPECT_EQ(tree_.move_many(ids_, boxes_), Status::ok);
    tree_.step();
    EXPECT_TRUE(same_pairs(tree_.pairs(), oracle_pairs(tree_.objects())));
    EXPECT_TRUE(validate(tree_.tree()).empty());
  }
  /// The object goes, and comes back at the place of another before the next step.
  void renew(std::uint32_t id, std::uint32_t place, Mobility mobility) {
    boxes_[id] = boxes_[place];
    EXPECT_EQ(tree_.remove({id}), Status::ok);
    EXPECT_EQ(tree_.insert({id}, boxes_[id], mobility), Status::ok);
  }
  /// The last object is gone.
  void drop_last() {
    EXPECT_EQ(tree_.remove(ids_.back()), Status::ok);
    ids_.pop_back();
    boxes_.pop_back();
  }
  /// One more, at the place of another.
  void add(std::uint32_t place) {
    const auto id = static_cast<std::uint32_t>(ids_.size());
    ids_.push_back({id});
    boxes_.push_back(boxes_[place]);
    EXPECT_EQ(tree_.insert({id}, boxes_[id], Mobility::moving), Status::ok);
  }
  /// Some of the objects move before all of them do, as when a host moves its bodies and then the origin.
  void move_some() {
    for (std::uint32_t id = 1; id < 40; id += 8) {
      for (int axis = 0; axis < D; ++axis) {
        boxes_[id].min[axis] += 0.001F;
        boxes_[id].max[axis] += 0.001F;
      }
      EXPECT_EQ(tree_.move({id}, boxes_[id]), Status::ok);
    }
  }
  void steps(int count) {
    for (int k = 0; k < count; ++k) step();
  }
  [[nodiscard]] const Bsp<D>& tree() const { return tree_; }
  Random& random() { return random_; }

 private:
  Random random_{11};
  double moving_;
  double reach_;
  std::vector<ObjectId> ids_;
  std::vector<Box<D>> boxes_;
  Bsp<D> tree_{leaves_of_32()};
};

template <class Dim>
class Shifts : public testing::Test {};
TYPED_TEST_SUITE(Shifts, Dimensions, DimensionNames);

/// Far shifts round the boxes, so that touching ones overlap or part.
TYPED_TEST(Shifts, PairsAreThoseOfTheBoxesWhereverTheOriginIs) {
  constexpr int kD = TypeParam::value;
  for (const double moving : {0.0, 0.05, 1.0}) {
    ShiftedWorld<kD> world(moving, 0.01);
    world.steps(12);
    for (const double reach : {5.0, 300.0, 1e5, 3e7}) {
      for (int k = 0; k < 6; ++k) {
        world.step(random_point<kD>(world.random(), -reach, reach));
        world.steps(k);
      }
    }
  }
}

/// Neither what is kept nor how the tree is divided is given up.
TYPED_TEST(Shifts, TheTreeComesAlong) {
  constexpr int kD = TypeParam::value;
  ShiftedWorld<kD> world(0.05, 0.01);
  world.steps(40);
  ASSERT_EQ(world.tree().mode(), Mode::kept);
  const Statistics before = world.tree().statistics();
  ASSERT_GT(before.leaves, 8U);
  for (int k = 0; k < 10; ++k) {
    Vector<kD> by;
    by[k % kD] = 100;
    world.step(by);
    EXPECT_EQ(world.tree().mode(), Mode::kept) << "shift " << k;
    world.steps(5);
    EXPECT_EQ(world.tree().mode(), Mode::kept) << "after shift " << k;
  }
  const Statistics after = world.tree().statistics();
  EXPECT_NEAR(after.leaves, before.leaves, before.leaves / 4.0);
  EXPECT_LE(after.operators[0] + after.operators[2], before.operators[0] + before.operators[2] + 20);
}

/// Its fat box does not come along.
TYPED_TEST(Shifts, WhatMovesElsewhereInTheSameStepIsFoundThere) {
  constexpr int kD = TypeParam::value;
  ShiftedWorld<kD> world(0.01, 0.01);
  world.steps(40);
  for (std::uint32_t k = 0; k < 10; ++k) {
    Vector<kD> by;
    by[0] = k % 2 == 0 ? 100 : -100;
    world.step(by, std::pair{8 * k + 1, 8 * k + 2});
    EXPECT_EQ(world.tree().mode(), Mode::kept) << "shift " << k;
    world.steps(5);
  }
}

/// Only what an object moved beside the shift counts: no more are fast than without a shift.
TYPED_TEST(Shifts, WhatLeavesItsFatBoxInAShiftIsNotRestless) {
  constexpr int kD = TypeParam::value;
  const auto count_restless = [](const Vector<kD>& by) {
    ShiftedWorld<kD> world(0.1, 0.03);
    world.steps(40);
    EXPECT_EQ(world.tree().mode(), Mode::kept);
    world.step(by);
    EXPECT_EQ(world.tree().mode(), Mode::kept);
    return std::ranges::count_if(world.tree().state().skins, &Skin::is_restless);
  };
  Vector<kD> by;
  by[0] = 128;
  EXPECT_LE(count_restless(by), count_restless({}));
}

/// Objects that come, go or get fixed in the step of a shift, between others that come along, some of
/// which move twice.
TYPED_TEST(Shifts, WhatComesInTheSameStepIsFound) {
  constexpr int kD = TypeParam::value;
  ShiftedWorld<kD> world(0.05, 0.01);
  world.steps(40);
  for (std::uint32_t k = 0; k < 10; ++k) {
    for (std::uint32_t id = k; id < 60; id += 10)
      world.renew(id, 100 + id, id % 3 == 0 ? Mobility::fixed : Mobility::moving);
    k % 3 == 0 ? world.add(k + 20) : world.drop_last();
    world.move_some();
    Vector<kD> by;
    by[0] = k % 2 == 0 ? 100 : -100;
    world.step(by);
    EXPECT_EQ(world.tree().mode(), Mode::kept) << "shift " << k;
    world.steps(3);
  }
}

/// Half of the objects move by a good part of their size.
TYPED_TEST(Shifts, IsKnownThoughMuchMovesBesideIt) {
  constexpr int kD = TypeParam::value;
  ShiftedWorld<kD> world(0.5, 0.15);
  world.steps(40);
  ASSERT_EQ(world.tree().mode(), Mode::swept);
  const Tree<kD>& tree = world.tree().tree();
  for (int k = 0; k < 10; ++k) {
    const Plane<kD> before = tree[tree.root()].plane;
    Vector<kD> by;
    by[k % kD] = 100;
    world.step(by);
    EXPECT_NEAR(tree[tree.root()].plane.offset, before.offset + dot(before.normal, by), 2) << "shift " << k;
    world.steps(3);
  }
}

/// Not to move at all is no common motion, though it is as far as a point is large.
TYPED_TEST(Shifts, PointsAtRestAreKept) {
  constexpr int kD = TypeParam::value;
  Random random(5);
  std::vector<ObjectId> ids;
  std::vector<Box<kD>> points;
  Bsp<kD> tree(leaves_of_32());
  for (std::uint32_t id = 0; id < 600; ++id) {
    const Vector<kD> at = random_point<kD>(random, 0, 10);
    ids.push_back({id});
    points.push_back({at, at});
    ASSERT_EQ(tree.insert({id}, points.back(), Mobility::moving), Status::ok);
  }
  tree.step();
  for (int k = 0; k < 4; ++k) {
    EXPECT_EQ(tree.move_many(ids, points), Status::ok);
    tree.step();
  }
  EXPECT_EQ(tree.mode(), Mode::kept);
}

/// A world that flies by in every step is swept, not kept.
TYPED_TEST(Shifts, WhatShiftsInEachStepIsSwept) {
  constexpr int kD = TypeParam::value;
  ShiftedWorld<kD> world(0.05, 0.01);
  world.steps(40);
  Vector<kD> by;
  by[0] = 3;
  for (int k = 0; k < 12; ++k) world.step(by);
  EXPECT_EQ(world.tree().mode(), Mode::swept);
}

}  // namespace
}  // namespace kerf::test
