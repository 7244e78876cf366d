// Descriptions of our broad phases' structures keep what they promise, on scenes that hurt them, too.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "core/broad_phase/columns.h"
#include "core/broad_phase/describe.h"
#include "core/broad_phase/loose_octree.h"
#include "core/broad_phase/sort_and_sweep.h"
#include "core/broad_phase/sweep_and_prune.h"
#include "core/bsp/bsp.h"
#include "core/query/structure_check.h"
#include "core/query/structure_measures.h"
#include "core/related/auxiliary_planes.h"
#include "core/related/chosen_planes.h"
#include "core/related/kinetic_tree.h"
#include "core/related/multi_level_hash.h"
#include "core/related/rebuilt_tree.h"
#include "core/related/reinserting_tree.h"
#include "core/related/self_organising_tree.h"
#include "core/related/shifting_cuts.h"
#include "core/related/sphere_tree.h"
#include "tests/support/boxes.h"
#include "tests/support/known_boxes.h"
#include "tests/support/moving_boxes.h"

namespace kerf::test {
namespace {

template <class B>
struct DimensionOf;
template <template <int> class B, int D>
struct DimensionOf<B<D>> {
  static constexpr int kValue = D;
};

template <class B>
class OwnStructure : public testing::Test {
 protected:
  static constexpr int kDimension = DimensionOf<B>::kValue;
  static constexpr std::uint32_t kCount = 300;

  OwnStructure() : known_(subject_), crowd_(known_, 3.5 * std::pow(kCount, 1.0 / kDimension), 1.5, 11) {}

  void insert(std::uint32_t id, const Box<kDimension>& box) {
    static_cast<void>(known_.insert({id}, box, id % 9 == 0 ? Mobility::fixed : Mobility::moving));
  }
  /// A step, after which the structure must be sound and its tests must include each pair.
  void step() {
    known_.step();
    const StructureParts<kDimension> parts = describe<kDimension>(subject_);
    const auto faults = check_structure<kDimension>(parts, known_.objects(), subject_.pairs());
    for (const StructureFault& fault : faults) ADD_FAILURE() << to_string(fault.kind) << ": " << fault.text;
    EXPECT_TRUE(parts.tells_tested);
    EXPECT_EQ(parts.tests, parts.tested.size());
    EXPECT_TRUE(known_.objects().empty() || !parts.cells.empty() || !parts.lists.empty());
  }

  B subject_;
  KnownBoxes<kDimension> known_;
  MovingBoxes<kDimension> crowd_;
};

using Subjects =
    testing::Types<Columns<2>, Columns<3>, SortAndSweep<2>, SortAndSweep<3>, SweepAndPrune<2>,
                   SweepAndPrune<3>, LooseOctree<2>, LooseOctree<3>, Bsp<2>, Bsp<3>, RebuiltTree<2>,
                   RebuiltTree<3>, ReinsertingTree<2>, ReinsertingTree<3>, AuxiliaryPlanes<2>,
                   AuxiliaryPlanes<3>, ShiftingCuts<2>, ShiftingCuts<3>, SelfOrganisingTree<2>,
                   SelfOrganisingTree<3>, KineticTree<2>, KineticTree<3>, MultiLevelHash<2>,
                   MultiLevelHash<3>, SphereTree<2>, SphereTree<3>, FixedDirections<2>, FixedDirections<3>,
                   PrincipalComponents<2>, PrincipalComponents<3>, EvolvedPlanes<2>, EvolvedPlanes<3>>;
TYPED_TEST_SUITE(OwnStructure, Subjects);

TYPED_TEST(OwnStructure, IsSoundWhileBoxesBounceAndTeleport) {
  this->crowd_.add(this->kCount, 5);
  for (std::uint32_t step = 1; step <= 30; ++step) {
    this->crowd_.bounce(1);
    if (step % 10 == 0) this->crowd_.teleport();
    this->step();
  }
}

TYPED_TEST(OwnStructure, IsSoundWhileObjectsComeGoAndAreQuarantined) {
  for (std::uint32_t step = 1; step <= 30; ++step) {
    this->crowd_.add(step % 7 == 0 ? 90 : 10, 4);
    this->crowd_.walk(0.5);
    this->crowd_.damage(5);
    if (step % 4 == 0) this->crowd_.heal();
    this->crowd_.replace(5);
    if (step % 5 == 0) this->crowd_.remove(20);
    this->step();
  }
}

TYPED_TEST(OwnStructure, IsSoundWithBoxesOfVeryDifferentSizes) {
  constexpr int kD = TestFixture::kDimension;
  Random random(7);
  for (std::uint32_t id = 0; id < 300; ++id)
    this->insert(id, box_at<kD>(random_point<kD>(random, 0, 100),
                                static_cast<Scalar>(std::exp2(random.uniform(-12, 7)))));
  this->step();
}

TYPED_TEST(OwnStructure, IsSoundOnALatticeOfTouchingBoxes) {
  constexpr int kD = TestFixture::kDimension;
  for (std::uint32_t id = 0; id < (kD == 2 ? 64U : 512U); ++id) {
    Vector<kD> low;
    for (int axis = 0; axis < kD; ++axis) low[axis] = static_cast<Scalar>((id >> (3 * axis)) % 8);
    this->insert(id, {low, low + all<kD>(1)});
  }
  this->step();
}

TYPED_TEST(OwnStructure, IsSoundAtTheEndsOfTheFloats) {
  constexpr int kD = TestFixture::kDimension;
  constexpr Scalar kMax = std::numeric_limits<Scalar>::max();
  std::uint32_t id = 0;
  for (const Scalar low : {-kMax, -kMax / 2, -1.0F, -0.0F, 0.0F, 1.0F, 1e9F, kMax})
    for (const Scalar high : {-kMax, -kMax / 2, -1.0F, -0.0F, 0.0F, 1.0F, 1e9F, kMax})
      if (low <= high) this->insert(id++, {all<kD>(low), all<kD>(high)});
  this->step();
}

TYPED_TEST(OwnStructure, IsSoundWithoutObjects) {
  this->known_.step();
  const auto parts = describe<TestFixture::kDimension>(this->subject_);
  EXPECT_TRUE(check_structure<TestFixture::kDimension>(parts, {}, {}).empty());
  EXPECT_TRUE(parts.members.empty());
  this->crowd_.add(50);
  this->step();
  this->crowd_.remove(50);
  this->step();
}

/// Two runs have the same description.
TYPED_TEST(OwnStructure, IsTheSameInEachRun) {
  constexpr int kD = TestFixture::kDimension;
  const auto run = [] {
    TypeParam subject;
    MovingBoxes<kD> crowd(subject, 30, 1.5, 11);
    crowd.add(200, 5);
    for (int step = 0; step < 12; ++step) {
      crowd.bounce(1);
      subject.step();
    }
    return describe<kD>(subject);
  };
  const StructureParts<kD> a = run();
  const StructureParts<kD> b = run();
  EXPECT_EQ(a.members, b.members);
  EXPECT_EQ(a.tested, b.tested);
  EXPECT_EQ(a.bytes, b.bytes);
  ASSERT_EQ(a.cells.size(), b.cells.size());
  for (std::size_t k = 0; k < a.cells.size(); ++k) {
    EXPECT_EQ(a.cells[k].box, b.cells[k].box);
    EXPECT_EQ(a.cells[k].parent, b.cells[k].parent);
    EXPECT_EQ(a.cells[k].name, b.cells[k].name);
  }
}

TEST(Structure, TheTunedTreeSaysThatItsTestsAreNotKnown) {
  Bsp<2> tree(tuned_config());
  MovingBoxes<2> crowd(tree, 30, 1.5, 11);
  crowd.add(200);
  tree.step();
  const StructureParts<2> parts = describe<2>(tree);
  EXPECT_FALSE(parts.tells_tested);
  EXPECT_FALSE(parts.tests);
  EXPECT_FALSE(parts.unseen.empty());
  EXPECT_FALSE(parts.cells.empty());
}

/// A tree of cuts says what it is: each cell of two children is cut where they meet.
TEST(Structure, CutsLieBetweenTheCellsThatTheyDivide) {
  RebuiltTree<2> tree;
  MovingBoxes<2> crowd(tree, 30, 1.5, 11);
  crowd.add(200);
  tree.step();
  const StructureParts<2> parts = describe<2>(tree);
  ASSERT_EQ(parts.cuts.size() + 1, parts.cells.size());
  for (const StructureCell<2>& cell : parts.cells) {
    if (cell.cut == kNoPart) continue;
    const Cut<2>& cut = parts.cuts[cell.cut];
    const int axis = cut.plane.normal[0] > 0 ? 0 : 1;
    const Scalar border = cut.right ? cell.box.min[axis] : cell.box.max[axis];
    EXPECT_EQ(cut.plane.offset, std::nextafter(border, -std::numeric_limits<Scalar>::infinity()));
  }
}

TEST(Structure, LevelsOfAHashAreDepthsFromTheCoarsestDown) {
  MultiLevelHash<2> hash;
  static_cast<void>(hash.insert({0}, {{{0, 0}}, {{3, 3}}}, Mobility::moving));
  static_cast<void>(hash.insert({1}, {{{1, 1}}, {{1.5F, 1.5F}}}, Mobility::moving));
  hash.step();
  const StructureParts<2> parts = describe<2>(hash);
  ASSERT_EQ(parts.cells.size(), 5U);
  EXPECT_EQ(parts.cells[0].depth, 0U);
  EXPECT_EQ(parts.cells[0].box, (Box<2>{{{0, 0}}, {{4, 4}}}));
  EXPECT_EQ(parts.cells[1].depth, 1U);
  EXPECT_EQ(parts.cells[1].box, (Box<2>{{{1, 1}}, {{1.5F, 1.5F}}}));
  EXPECT_EQ(parts.tested, std::vector<Pair>(1, {{0}, {1}}));
}

TEST(Structure, SpheresAreKnownByTheirBoxes) {
  SphereTree<2> spheres;
  static_cast<void>(spheres.insert({0}, {{{0, 0}}, {{6, 8}}}, Mobility::moving));
  spheres.step();
  const StructureParts<2> parts = describe<2>(spheres);
  EXPECT_TRUE(parts.is_round);
  ASSERT_EQ(parts.cells.size(), 1U);
  EXPECT_NEAR(parts.cells[0].box.min[0], -2, 1e-5);
  EXPECT_NEAR(parts.cells[0].box.max[1], 9, 1e-5);
}

TEST(Structure, MeasuresOverlapAndDeadSpace) {
  StructureParts<2> parts;
  parts.cells = {{{{{0, 0}}, {{4, 1}}}, 0, kNoPart, 0, kNoPart},
                 {{{{0, 0}}, {{3, 1}}}, 1, 0, 1, kNoPart},
                 {{{{2, 0}}, {{4, 1}}}, 2, 0, 1, kNoPart}};
  parts.members = {{1, {0}}, {2, {1}}};
  const std::vector<Box<2>> boxes{{{{0, 0}}, {{1.5F, 1}}}, {{{2, 0}}, {{4, 1}}}};
  const StructureMeasures measures = measure<2>(parts, boxes, {{{-9, -9}}, {{9, 9}}});
  EXPECT_DOUBLE_EQ(measures.overlap, 0.25);  // from 2 to 3 of 0 to 4
  EXPECT_DOUBLE_EQ(measures.dead, 0.5 / 3);  // half of the first leaf, nothing of the others
  EXPECT_EQ(measures.depth, 1U);
  EXPECT_EQ(measures.members, 2U);
}

}  // namespace
}  // namespace kerf::test
