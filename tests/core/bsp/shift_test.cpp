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
#include "tests/support/config_of.h"
#include "tests/support/dimensions.h"
#include "tests/support/pairs.h"

namespace kerf::test {
namespace {

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
    check_step();
  }
  /// One step, in which every tenth object is not named and stays where it is, and all others move by the
  /// vector.
  void leave_some_behind(const Vector<D>& by) {
    for (std::uint32_t id = 0; id < ids_.size(); ++id) {
      if (id % 10 == 3) continue;
      boxes_[id] = {boxes_[id].min + by, boxes_[id].max + by};
      EXPECT_EQ(tree_.move({id}, boxes_[id]), Status::ok);
    }
    check_step();
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
  void check_step() {
    tree_.step();
    EXPECT_TRUE(same_pairs(tree_.pairs(), oracle_pairs(tree_.objects())));
    EXPECT_TRUE(validate(tree_.tree()).empty());
  }

  Random random_{11};
  double moving_;
  double reach_;
  std::vector<ObjectId> ids_;
  std::vector<Box<D>> boxes_;
  Bsp<D> tree_{tuned_with_leaves_of(32)};
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

/// Bricks at rest with gaps that many a shift closes, and some that come to rest or begin to move beside
/// them. Gaps of one unit in the last place are closed by the first shift that is far enough, others only by
/// several.
TYPED_TEST(Shifts, RoundingLetsBoxesTouchThatRest) {
  constexpr int kD = TypeParam::value;
  Random random(3);
  std::vector<ObjectId> ids;
  std::vector<Box<kD>> bricks;
  Bsp<kD> tree(tuned_with_leaves_of(32));
  const auto side = static_cast<std::uint32_t>(kD == 2 ? 24 : 8);
  for (std::uint32_t id = 0; id < (kD == 2 ? side * side : side * side * side); ++id) {
    Box<kD> brick;
    for (std::uint32_t axis = 0, rest = id; axis < kD; ++axis, rest /= side) {
      const auto at = static_cast<float>(rest % side) - 0.4F * static_cast<float>(side);
      brick.min[axis] = at + static_cast<float>(random.uniform(0, 2e-6));
      brick.max[axis] = at + 1 - static_cast<float>(random.uniform(0, 1e-5));
    }
    ids.push_back({id});
    bricks.push_back(brick);
    ASSERT_EQ(tree.insert({id}, brick, Mobility::moving), Status::ok);
  }
  Vector<kD> origin;
  std::size_t least = bricks.size() * bricks.size();
  std::size_t most = 0;
  for (int k = 0; k < 400; ++k) {
    Vector<kD> by;
    if (k > 40 && k % 5 == 0) by = random_point<kD>(random, -60, 60) - origin;
    origin = origin + by;
    const auto nudged = static_cast<std::size_t>(random.uniform(0, static_cast<double>(bricks.size())));
    for (std::size_t id = 0; id < bricks.size(); ++id) {
      const Vector<kD> way = id == nudged ? random_point<kD>(random, -1e-6, 1e-6) + by : by;
      bricks[id] = {bricks[id].min + way, bricks[id].max + way};
    }
    ASSERT_EQ(tree.move_many(ids, bricks), Status::ok);
    tree.step();
    ASSERT_TRUE(same_pairs(tree.pairs(), oracle_pairs(tree.objects()))) << "step " << k;
    ASSERT_TRUE(validate(tree.tree()).empty()) << "step " << k;
    ASSERT_TRUE(k <= 40 || tree.mode() == Mode::kept) << "step " << k;
    least = std::min(least, tree.pairs().size());
    most = std::max(most, tree.pairs().size());
  }
  EXPECT_LT(least, most / 2);
}

/// The gaps are wider than what near shifts could close.
TYPED_TEST(Shifts, AFarOneLetsMoreTouchThanNearOnes) {
  constexpr int kD = TypeParam::value;
  Random random(9);
  std::vector<ObjectId> ids;
  std::vector<Box<kD>> boxes;
  Bsp<kD> tree(tuned_with_leaves_of(32));
  for (std::uint32_t id = 0; id < 400; ++id) {
    Box<kD> box = random_box<kD>(random, 10, 0.5);
    if (id % 2 == 1) {  // beside the one before
      box = boxes.back();
      box.min[0] = box.max[0] + static_cast<float>(random.uniform(1.4e-4, 2e-4));
      box.max[0] = box.min[0] + 0.5F;
    }
    ids.push_back({id});
    boxes.push_back(box);
    ASSERT_EQ(tree.insert({id}, box, Mobility::moving), Status::ok);
  }
  std::size_t near = 0;
  for (int k = 0; k < 80; ++k) {
    Vector<kD> by;
    if (k > 40 && k % 4 == 0) by[0] = k % 8 == 0 ? 2.0F : -2.0F;
    if (k == 78) by[0] = 3000;
    if (k == 77) near = tree.pairs().size();
    for (Box<kD>& box : boxes) box = {box.min + by, box.max + by};
    ASSERT_EQ(tree.move_many(ids, boxes), Status::ok);
    tree.step();
    ASSERT_TRUE(same_pairs(tree.pairs(), oracle_pairs(tree.objects()))) << "step " << k;
    ASSERT_TRUE(k <= 40 || tree.mode() == Mode::kept) << "step " << k;
  }
  EXPECT_GT(tree.pairs().size(), near + 40);
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

/// By a shift that leaves some of them among the others, and by a far one.
TYPED_TEST(Shifts, WhatDoesNotMoveStays) {
  constexpr int kD = TypeParam::value;
  ShiftedWorld<kD> world(0.01, 0.01);
  world.steps(40);
  for (int k = 0; k < 10; ++k) {
    Vector<kD> by;
    by[k % kD] = k % 4 == 3 ? 100.0F : 2.0F;
    world.leave_some_behind(by);
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

/// One object lies where the shift would take it beyond the largest float, so the others cannot take the tree
/// along.
TYPED_TEST(Shifts, BeyondTheLargestFloatAllIsPlacedAnew) {
  constexpr int kD = TypeParam::value;
  constexpr Scalar kFar = 3e38F;
  Random random(14);
  std::vector<ObjectId> ids;
  std::vector<Box<kD>> boxes;
  Bsp<kD> tree(tuned_with_leaves_of(32));
  for (std::uint32_t id = 0; id < 400; ++id) {
    boxes.push_back(random_box<kD>(random, 10, 0.5));
    ids.push_back({id});
    if (id == 399) boxes.back().min[0] = boxes.back().max[0] = kFar;
    ASSERT_EQ(tree.insert({id}, boxes.back(), Mobility::moving), Status::ok);
  }
  Vector<kD> far;
  far[0] = kFar / 2;
  for (int k = 0; k < 60; ++k) {
    if (k >= 40 && k % 4 == 0) {
      const Vector<kD> by = k % 8 == 0 ? far : all<kD>(0) - far;
      for (std::uint32_t id = 0; id < 399; ++id) boxes[id] = {boxes[id].min + by, boxes[id].max + by};
    }
    ASSERT_EQ(tree.move_many(ids, boxes), Status::ok);
    tree.step();
    ASSERT_TRUE(same_pairs(tree.pairs(), oracle_pairs(tree.objects()))) << "step " << k;
    ASSERT_TRUE(validate(tree.tree()).empty()) << "step " << k;
    ASSERT_TRUE(k != 39 || tree.mode() == Mode::kept);
  }
}

/// Not to move at all is no common motion, though it is as far as a point is large.
TYPED_TEST(Shifts, PointsAtRestAreKept) {
  constexpr int kD = TypeParam::value;
  Random random(5);
  std::vector<ObjectId> ids;
  std::vector<Box<kD>> points;
  Bsp<kD> tree(tuned_with_leaves_of(32));
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
