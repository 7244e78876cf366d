// Our broad phases make the same promise: each step's pairs are the oracle's, each once. So do the
// descriptions of their structures: they are sound after each step, and each pair is among their tests.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "core/broad_phase/all_pairs.h"
#include "core/broad_phase/columns.h"
#include "core/broad_phase/describe.h"
#include "core/broad_phase/loose_octree.h"
#include "core/broad_phase/sort_and_sweep.h"
#include "core/broad_phase/sweep_and_prune.h"
#include "core/bsp/bsp.h"
#include "core/query/structure_check.h"
#include "core/related/auxiliary_planes.h"
#include "core/related/chosen_planes.h"
#include "core/related/kinetic_tree.h"
#include "core/related/multi_level_hash.h"
#include "core/related/rebuilt_tree.h"
#include "core/related/reinserting_tree.h"
#include "core/related/self_organising_tree.h"
#include "core/related/shifting_cuts.h"
#include "core/related/sphere_tree.h"
#include "tests/hard/flush_to_zero.h"
#include "tests/support/boxes.h"
#include "tests/support/checked.h"
#include "tests/support/known_boxes.h"
#include "tests/support/moving_boxes.h"

namespace kerf::test {
namespace {

template <class B>
struct DimensionOf;
template <template <int, class...> class B, int D, class... Others>
struct DimensionOf<B<D, Others...>> {
  static constexpr int kValue = D;
};

struct BroadPhaseNames {
  template <class B>
  static std::string GetName(int /*index*/) {  // NOLINT(readability-identifier-naming): GoogleTest's name
    std::string name(B().name());
    // ctest asks for one test by --gtest_filter, where a '-' would mean "but not".
    std::replace(name.begin(), name.end(), '-', '_');
    return name + "_" + std::to_string(DimensionOf<B>::kValue) + "D";
  }
};

template <class B>
class OwnBroadPhase : public testing::Test {
 protected:
  static constexpr int kDimension = DimensionOf<B>::kValue;
  static constexpr std::uint32_t kCount = 700;

  OwnBroadPhase() : known_(subject_), checked_(known_), crowd_(checked_, world(), 1.5, 11) {}
  static double world() { return 3.5 * std::pow(kCount, 1.0 / kDimension); }
  void insert(std::uint32_t id, const Box<kDimension>& box, Mobility mobility = Mobility::moving) {
    static_cast<void>(checked_.insert({id}, box, mobility));
  }

  void step() {
    checked_.step();
    if constexpr (!std::is_same_v<B, AllPairs<kDimension>>) check_description();
  }
  void check_description() {
    const StructureParts<kDimension> parts = describe<kDimension>(subject_);
    const auto faults = check_structure<kDimension>(parts, known_.objects(), subject_.pairs());
    for (const StructureFault& fault : faults) ADD_FAILURE() << to_string(fault.kind) << ": " << fault.text;
    EXPECT_TRUE(parts.tells_tested);
    EXPECT_EQ(parts.tests, parts.tested.size());
    EXPECT_TRUE(known_.objects().empty() || !parts.cells.empty() || !parts.lists.empty());
  }

  B subject_;
  KnownBoxes<kDimension> known_;
  Checked<kDimension> checked_;
  MovingBoxes<kDimension> crowd_;
};

using Subjects =
    testing::Types<Columns<2>, Columns<3>, SortAndSweep<2>, SortAndSweep<3>, SweepAndPrune<2>,
                   SweepAndPrune<3>, LooseOctree<2>, LooseOctree<3>, Bsp<2>, Bsp<3>, AllPairs<2>, AllPairs<3>,
                   RebuiltTree<2>, RebuiltTree<3>, ReinsertingTree<2>, ReinsertingTree<3>, AuxiliaryPlanes<2>,
                   AuxiliaryPlanes<3>, ShiftingCuts<2>, ShiftingCuts<3>, SelfOrganisingTree<2>,
                   SelfOrganisingTree<3>, KineticTree<2>, KineticTree<3>, MultiLevelHash<2>,
                   MultiLevelHash<3>, SphereTree<2>, SphereTree<3>, FixedDirections<2>, FixedDirections<3>,
                   PrincipalComponents<2>, PrincipalComponents<3>, EvolvedPlanes<2>, EvolvedPlanes<3>>;
TYPED_TEST_SUITE(OwnBroadPhase, Subjects, BroadPhaseNames);

TYPED_TEST(OwnBroadPhase, AgreesOnBouncingBoxesAndTeleports) {
  this->crowd_.add(this->kCount, 5);
  for (std::uint32_t step = 1; step <= 30; ++step) {
    this->crowd_.bounce(1);
    if (step % 10 == 0) this->crowd_.teleport();
    this->step();
  }
}

TYPED_TEST(OwnBroadPhase, AgreesWhenAClusterCollapsesAndExplodes) {
  this->crowd_.add(this->kCount);
  for (std::uint32_t step = 1; step <= 30; ++step) {
    this->crowd_.gather(step % 20 < 10 ? 0.35 : -0.5);
    this->step();
  }
}

TYPED_TEST(OwnBroadPhase, AgreesWhileObjectsComeGoAndAreQuarantined) {
  for (std::uint32_t step = 1; step <= 40; ++step) {
    this->crowd_.add(step % 7 == 0 ? 90 : 10, 4);
    this->crowd_.walk(0.5);
    this->crowd_.damage(5);
    if (step % 4 == 0) this->crowd_.heal();
    this->crowd_.replace(5);
    if (step % 5 == 0) this->crowd_.remove(step == 35 ? this->crowd_.size() : 30);
    this->step();
  }
}

TYPED_TEST(OwnBroadPhase, IsSoundWithoutObjects) {
  this->step();
  EXPECT_TRUE(describe<TestFixture::kDimension>(this->subject_).members.empty());
  this->crowd_.add(50);
  this->step();
  this->crowd_.remove(50);
  this->step();
}

/// Nothing comes in the same step.
TYPED_TEST(OwnBroadPhase, AgreesWhenObjectsOnlyGo) {
  this->crowd_.add(this->kCount, 4);
  this->step();
  for (std::uint32_t step = 1; step <= 5; ++step) {
    this->crowd_.remove(50);
    this->step();
    this->crowd_.damage(50);
    this->step();
  }
  this->crowd_.heal();
  this->step();
}

TYPED_TEST(OwnBroadPhase, KeepsBoxesADenormalApartWhereACallerTakesDenormalsForZero) {
  constexpr Scalar kTiny = 0x1p-140F;
  Box<TestFixture::kDimension> left = test::box_at<TestFixture::kDimension>({}, 1);
  Box<TestFixture::kDimension> right = left;
  left.max[0] = kTiny;
  right.min[0] = 2 * kTiny;
  const FlushToZero flush(true);
  static_cast<void>(this->subject_.insert({0}, left, Mobility::moving));
  static_cast<void>(this->subject_.insert({1}, right, Mobility::moving));
  this->subject_.step();
  EXPECT_TRUE(this->subject_.pairs().empty());
  right.max[0] = kTiny;
  EXPECT_EQ(this->subject_.move({1}, right), Status::quarantined);
}

TYPED_TEST(OwnBroadPhase, AgreesOnBoxesOfVeryDifferentSizes) {
  constexpr int kD = TestFixture::kDimension;
  Random random(7);
  for (std::uint32_t id = 0; id < 400; ++id) {
    const double size = std::exp2(random.uniform(-12, 7));
    this->insert(id, box_at<kD>(random_point<kD>(random, 0, 100), static_cast<Scalar>(size)),
                 id % 9 == 0 ? Mobility::fixed : Mobility::moving);
  }
  this->step();
}

TYPED_TEST(OwnBroadPhase, AgreesOnALatticeOfTouchingBoxes) {
  constexpr int kD = TestFixture::kDimension;
  for (std::uint32_t id = 0; id < 512; ++id) {
    Vector<kD> low;
    for (int axis = 0; axis < kD; ++axis) low[axis] = static_cast<Scalar>((id >> (3 * axis)) % 8);
    this->insert(id, {low, low + all<kD>(1)});
  }
  this->step();
}

/// Nothing but the largest floats, opposite zeros, points, and a single box far out.
TYPED_TEST(OwnBroadPhase, AgreesAtTheEndsOfTheFloats) {
  constexpr int kD = TestFixture::kDimension;
  constexpr Scalar kEnd = std::numeric_limits<Scalar>::max();
  constexpr Scalar kTiny = std::numeric_limits<Scalar>::denorm_min();
  const std::vector<Scalar> ends{-kEnd, -kEnd / 2, -1, -kTiny, -0.0F, 0.0F, kTiny, 1, 1e9F, kEnd / 2, kEnd};
  std::uint32_t id = 0;
  for (const Scalar low : ends)
    for (const Scalar high : ends)
      if (low <= high) this->insert(id++, {all<kD>(low), all<kD>(high)});
  this->step();
  EXPECT_GT(this->subject_.pairs().size(), 500U);
}

TYPED_TEST(OwnBroadPhase, AgreesWhenAllButOneLieFarFromTheOther) {
  constexpr int kD = TestFixture::kDimension;
  this->crowd_.add(this->kCount);
  this->insert(this->kCount, box_at<kD>(all<kD>(1e30F), 1));
  this->step();
}

TYPED_TEST(OwnBroadPhase, AgreesWhenEverythingCoincides) {
  constexpr int kD = TestFixture::kDimension;
  for (std::uint32_t id = 0; id < 300; ++id) this->insert(id, box_at<kD>(all<kD>(5), 1));
  this->step();
  EXPECT_EQ(this->subject_.pairs().size(), 300U * 299U / 2);
}

TYPED_TEST(OwnBroadPhase, MovesManyAsMoveDoes) {
  constexpr int kD = TestFixture::kDimension;
  TypeParam one;
  Random random(3);
  std::vector<ObjectId> ids;
  std::vector<Box<kD>> boxes;
  for (std::uint32_t id = 0; id < 200; ++id) {
    this->insert(id, random_box<kD>(random, 20, 1.5));
    ASSERT_EQ(one.insert({id}, random_box<kD>(random, 20, 1.5), Mobility::moving), Status::ok);
    ids.push_back({id});
    boxes.push_back(random_box<kD>(random, 20, 1.5));
  }
  for (std::uint32_t id = 0; id < 200; ++id) static_cast<void>(this->checked_.move(ids[id], boxes[id]));
  EXPECT_EQ(one.move_many(ids, boxes), Status::ok);
  one.step();
  this->step();
  EXPECT_TRUE(same_pairs(one.pairs(), this->subject_.pairs()));
  ids.push_back({4000});
  boxes.push_back(boxes[0]);
  EXPECT_EQ(one.move_many(ids, boxes), Status::unknown_id);
}

}  // namespace
}  // namespace kerf::test
