// What the sources of the related work promise, and what the paper says of them. That all are exact is in
// own_broad_phases_test.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/related/auxiliary_planes.h"
#include "core/related/chosen_planes.h"
#include "core/related/kinetic_tree.h"
#include "core/related/multi_level_hash.h"
#include "core/related/principal_axes.h"
#include "core/related/rebuilt_tree.h"
#include "core/related/reinserting_tree.h"
#include "core/related/self_organising_tree.h"
#include "core/related/shifting_cuts.h"
#include "core/related/sphere_tree.h"
#include "tests/support/boxes.h"
#include "tests/support/checked.h"
#include "tests/support/dimensions.h"
#include "tests/support/moving_boxes.h"

namespace kerf::test {
namespace {

template <class Number>
class RelatedWork : public testing::Test {};
TYPED_TEST_SUITE(RelatedWork, Dimensions, DimensionNames);

/// Four groups of as many objects each, far from each other.
template <int D>
std::vector<Box<D>> four_groups(int count = 400) {
  Random random(5);
  std::vector<Box<D>> boxes;
  for (int k = 0; k < count; ++k) {
    Vector<D> at = random_point<D>(random, 0, 10);
    at[0] += static_cast<Scalar>(k % 2) * 100;
    at[1] += static_cast<Scalar>(k / 2 % 2) * 100;
    boxes.push_back(box_at<D>(at, 0.3F));
  }
  return boxes;
}

template <int D>
void insert_all(BroadPhase<D>& subject, const std::vector<Box<D>>& boxes) {
  for (std::uint32_t k = 0; k < boxes.size(); ++k)
    ASSERT_EQ(subject.insert({k}, boxes[k], Mobility::moving), Status::ok);
}

TYPED_TEST(RelatedWork, AnAuxiliaryPlaneKeepsMovementInItsGroup) {
  constexpr int kD = TypeParam::value;
  AuxiliaryPlanes<kD> subject;
  const std::vector<Box<kD>> boxes = four_groups<kD>();
  insert_all<kD>(subject, boxes);
  subject.step();
  ASSERT_GE(subject.groups(), 4U);
  EXPECT_EQ(subject.rebuilt_groups(), subject.groups());
  Box<kD> moved = boxes[0];
  moved.min[0] += 0.01F;
  moved.max[0] += 0.01F;
  ASSERT_EQ(subject.move({0}, moved), Status::ok);
  subject.step();
  EXPECT_GE(subject.rebuilt_groups(), 1U);
  EXPECT_LE(subject.rebuilt_groups(), 2U);
  subject.step();
  EXPECT_EQ(subject.rebuilt_groups(), 0U);
}

constexpr int kInSmallGroups = 240;  // no group is divided further

/// Objects 0, 4, 8 and so on are of the group at the origin; `count` of them reach into the next group.
template <int D>
void stretch(BroadPhase<D>& subject, std::uint32_t count, Scalar reach) {
  std::vector<Box<D>> boxes = four_groups<D>(kInSmallGroups);
  for (std::uint32_t k = 0; k < count; ++k) {
    boxes[4 * k].max[0] += reach;
    ASSERT_EQ(subject.move({4 * k}, boxes[4 * k]), Status::ok);
  }
  subject.step();
}

TYPED_TEST(RelatedWork, AuxiliaryPlanesAreChosenAnewWhenTooManyObjectsCrossThem) {
  constexpr int kD = TypeParam::value;
  AuxiliaryPlanes<kD> subject;
  insert_all<kD>(subject, four_groups<kD>(kInSmallGroups));
  subject.step();
  for (int turn = 0; turn < 3; ++turn) {
    stretch<kD>(subject, 15, 100);
    EXPECT_LT(subject.rebuilt_groups(), subject.groups()) << "15 of 240 objects may, turn " << turn;
    stretch<kD>(subject, 15, 0);
    EXPECT_LT(subject.rebuilt_groups(), subject.groups()) << turn;
  }
  stretch<kD>(subject, 30, 100);
  EXPECT_EQ(subject.rebuilt_groups(), subject.groups()) << "30 may not";
}

/// A row of objects along one axis, which `turn` of a quarter makes one along another.
template <int D>
std::vector<Box<D>> turned_row(double turn) {
  std::vector<Box<D>> boxes;
  for (int k = 0; k < 400; ++k) {
    Vector<D> at = all<D>(0);
    at[0] = static_cast<Scalar>(k * std::cos(turn * std::numbers::pi / 2));
    at[1] = static_cast<Scalar>(k * std::sin(turn * std::numbers::pi / 2));
    boxes.push_back(box_at<D>(at, 0.4F));
  }
  return boxes;
}

/// Cuts that only shift keep their axes, and a row that has turned is no longer divided by them.
TYPED_TEST(RelatedWork, ATreeOfShiftingCutsDegradesUnlessItIsBuiltAnew) {
  constexpr int kD = TypeParam::value;
  ShiftingCuts<kD> never(0);
  ShiftingCuts<kD> now_and_then(10);
  RebuiltTree<kD> always;
  Checked<kD> checked(never);
  const std::vector<BroadPhase<kD>*> subjects{&checked, &now_and_then, &always};
  for (auto* subject : subjects) insert_all<kD>(*subject, turned_row<kD>(0));
  for (int step = 0; step <= 20; ++step) {
    const std::vector<Box<kD>> boxes = turned_row<kD>(step / 20.0);
    for (auto* subject : subjects) {
      for (std::uint32_t k = 0; k < boxes.size(); ++k) ASSERT_EQ(subject->move({k}, boxes[k]), Status::ok);
      subject->step();
    }
  }
  EXPECT_GT(never.candidates(), 5 * always.candidates());
  EXPECT_EQ(now_and_then.candidates(), always.candidates()) << "it was built in this step";
}

TYPED_TEST(RelatedWork, APredictionHoldsAsLongAsObjectsKeepTheirVelocity) {
  constexpr int kD = TypeParam::value;
  KineticTree<kD> subject;
  Checked<kD> checked(subject);
  Random random(5);
  std::vector<Vector<kD>> places;
  std::vector<Vector<kD>> ways;
  for (std::uint32_t k = 0; k < 300; ++k) {
    places.push_back(random_point<kD>(random, 0, 30));
    ways.push_back(random_point<kD>(random, -0.05, 0.05));
    ASSERT_EQ(checked.insert({k}, box_at<kD>(places[k], 0.4F), Mobility::moving), Status::ok);
  }
  std::uint64_t failures = 0;
  for (int step = 0; step < 60; ++step) {
    for (std::uint32_t k = 0; k < 300; ++k) {
      places[k] = places[k] + ways[k] * (step < 50 ? 1.0F : 1 + 0.1F * static_cast<Scalar>(step - 49));
      ASSERT_EQ(checked.move({k}, box_at<kD>(places[k], 0.4F)), Status::ok);
    }
    checked.step();
    if (step > 2 && step < 50) {
      EXPECT_EQ(subject.surprises(), 0U) << step;
      failures += subject.failures();
    } else if (step > 50) {
      EXPECT_GT(subject.surprises(), 200U) << step;
    }
  }
  EXPECT_GT(failures, 0U);
  EXPECT_LT(failures, 300U * 47 / 4) << "most objects reach no cut in most steps";
}

TYPED_TEST(RelatedWork, ATreeIsDividedOnlyWhereItIsUsed) {
  constexpr int kD = TypeParam::value;
  SelfOrganisingTree<kD> subject;
  insert_all<kD>(subject, four_groups<kD>());
  subject.step();
  EXPECT_TRUE(subject.tree()[subject.tree().root()].is_leaf()) << "nothing has been asked of it yet";
  const std::uint64_t first = subject.candidates();
  for (int step = 0; step < 12; ++step) subject.step();
  EXPECT_LT(subject.candidates(), first / 4);
  for (std::uint32_t k = 12; k < 400; ++k) ASSERT_EQ(subject.remove({k}), Status::ok);
  for (int step = 0; step < 12; ++step) {
    for (std::uint32_t k = 0; k < 12; ++k)
      ASSERT_EQ(subject.move({k}, box_at<kD>(all<kD>(static_cast<Scalar>(k + 20 * (step % 2))), 0.1F)),
                Status::ok);
    subject.step();
  }
  EXPECT_TRUE(subject.tree()[subject.tree().root()].is_leaf()) << "what is used no more is forgotten";
}

TYPED_TEST(RelatedWork, CutsOfAStaticTreeStayWhereTheyAre) {
  constexpr int kD = TypeParam::value;
  ReinsertingTree<kD> subject;
  const std::vector<Box<kD>> boxes = four_groups<kD>();
  insert_all<kD>(subject, boxes);
  subject.step();
  const auto root = subject.tree()[subject.tree().root()];
  Random random(3);
  for (int step = 0; step < 5; ++step) {
    for (std::uint32_t k = 0; k < 400; ++k)
      ASSERT_EQ(subject.move({k}, box_at<kD>(random_point<kD>(random, 0, 50), 0.3F)), Status::ok);
    subject.step();
  }
  EXPECT_EQ(subject.tree()[subject.tree().root()].axis, root.axis);
  EXPECT_EQ(subject.tree()[subject.tree().root()].cut, root.cut);
  for (std::uint32_t k = 0; k < 400; ++k) ASSERT_EQ(subject.remove({k}), Status::ok);
  subject.step();
  EXPECT_TRUE(subject.tree()[subject.tree().root()].is_leaf());
  EXPECT_EQ(subject.tree().entries(), 0U);
}

/// Along a row of objects, whichever way it turns, lies the axis of the greatest variance.
TYPED_TEST(RelatedWork, PrincipalComponentsFollowTheObjects) {
  constexpr int kD = TypeParam::value;
  for (const double turn : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    std::vector<Vector<kD>> centres;
    for (const Box<kD>& box : turned_row<kD>(turn)) centres.push_back(box.center());
    const auto principal = principal_axes<kD>(centres);
    const double along = std::cos(turn * std::numbers::pi / 2) * double{principal.axes[0][0]} +
                         std::sin(turn * std::numbers::pi / 2) * double{principal.axes[0][1]};
    EXPECT_NEAR(std::abs(along), 1, 1e-5) << turn;
    EXPECT_NEAR(double{dot(principal.axes[0], principal.axes[1])}, 0, 1e-5) << turn;
  }
}

/// A slanting row: planes across it leave nothing to compare but neighbours, cuts along the axes too.
TYPED_TEST(RelatedWork, ChosenPlanesDivideASlantingRow) {
  constexpr int kD = TypeParam::value;
  const auto candidates_of = [](auto&& subject) {
    insert_all<kD>(subject, turned_row<kD>(0.5));
    subject.step();
    return subject.candidates();
  };
  EXPECT_LT(candidates_of(FixedDirections<kD>()), 400U * 16);
  EXPECT_LT(candidates_of(PrincipalComponents<kD>()), 400U * 16);
  EXPECT_LT(candidates_of(EvolvedPlanes<kD>()), 400U * 16);
}

TYPED_TEST(RelatedWork, ObjectsOfEachSizeHaveTheirLevel) {
  constexpr int kD = TypeParam::value;
  MultiLevelHash<kD> subject;
  insert_all<kD>(subject, {box_at<kD>(all<kD>(0), 0.25F), box_at<kD>(all<kD>(0.1F), 0.25F),
                           box_at<kD>(all<kD>(0), 40), box_at<kD>(all<kD>(30), 3)});
  subject.step();
  EXPECT_EQ(subject.levels(), 3U);
  EXPECT_EQ(subject.pairs().size(), 4U);
}

TYPED_TEST(RelatedWork, GroupsWhoseSpheresAreApartAreNotLookedInto) {
  constexpr int kD = TypeParam::value;
  SphereTree<kD> subject;
  insert_all<kD>(subject, four_groups<kD>());
  subject.step();
  EXPECT_LT(subject.candidates(), 400U * 399U / 2 / 2);
}

}  // namespace
}  // namespace kerf::test
