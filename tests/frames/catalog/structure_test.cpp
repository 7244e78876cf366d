// Descriptions of other libraries' structures keep what they promise; what cannot be seen
// says why.

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "core/broad_phase/describe.h"
#include "core/query/structure_check.h"
#include "frames/catalog/algorithm.h"
#include "frames/catalog/broad_phase_choice.h"
#include "frames/catalog/scene_catalog.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/known_boxes.h"
#include "tests/support/moving_boxes.h"

namespace kerf::test {
namespace {

const std::set<std::string> kUnseen{"cgal-box-intersection", "embree-collide", "ode-hash", "ode-quadtree",
                                    "ode-sap"};
const std::set<std::string> kWithoutStructure{"all-pairs", "brute-force"};

template <class T>
class Structures : public testing::Test {
 protected:
  static constexpr int kDimension = T::value;

  static std::unique_ptr<BroadPhase<kDimension>> make(const std::string& name) {
    RivalHints<kDimension> hints;
    hints.bounds = {all<kDimension>(-20), all<kDimension>(60)};
    return find_algorithm<kDimension>(name)->make(hints, 1);
  }

  static void check(const std::string& name, const KnownBoxes<kDimension>& known,
                    const BroadPhase<kDimension>& subject) {
    const StructureParts<kDimension> parts = describe(subject);
    for (const StructureFault& fault : check_structure<kDimension>(parts, known.objects(), subject.pairs()))
      ADD_FAILURE() << name << ": " << to_string(fault.kind) << ": " << fault.text;
    const bool is_seen = !parts.cells.empty() || !parts.lists.empty();
    EXPECT_EQ(is_seen, !kUnseen.contains(name) && !kWithoutStructure.contains(name)) << name;
    EXPECT_EQ(parts.unseen.empty(), is_seen && name != "kerf") << name << ": " << parts.unseen;
    EXPECT_EQ(parts.tells_tested, is_seen && name != "kerf") << name;
  }
};
TYPED_TEST_SUITE(Structures, Dimensions, DimensionNames);

TYPED_TEST(Structures, AreSoundWhileBoxesComeMoveAndGo) {
  constexpr int kD = TestFixture::kDimension;
  for (const std::string& name : broad_phase_names<kD>()) {
    const auto subject = TestFixture::make(name);
    KnownBoxes<kD> known(*subject);
    MovingBoxes<kD> crowd(known, 30, 1.5, 11);
    crowd.add(150, 5);
    for (std::uint32_t step = 1; step <= 20; ++step) {
      crowd.bounce(0.5);
      if (step % 5 == 0) crowd.replace(10);
      if (step % 7 == 0) crowd.remove(10);
      if (step == 15) crowd.teleport();
      known.step();
      TestFixture::check(name, known, *subject);
    }
  }
}

TYPED_TEST(Structures, AreSoundOnALatticeOfTouchingBoxesAndOnOneBox) {
  constexpr int kD = TestFixture::kDimension;
  for (const std::string& name : broad_phase_names<kD>()) {
    const auto subject = TestFixture::make(name);
    KnownBoxes<kD> known(*subject);
    static_cast<void>(known.insert({0}, {all<kD>(0), all<kD>(1)}, Mobility::moving));
    known.step();
    TestFixture::check(name, known, *subject);
    for (std::uint32_t id = 1; id < 64; ++id) {
      Vector<kD> low;
      for (int axis = 0; axis < kD; ++axis) low[axis] = static_cast<Scalar>((id >> (2 * axis)) % 4);
      static_cast<void>(known.insert({id}, {low, low + all<kD>(1)}, Mobility::moving));
    }
    known.step();
    TestFixture::check(name, known, *subject);
  }
}

/// The names of nodes are not addresses, which no two runs share.
TYPED_TEST(Structures, AreTheSameInEachRun) {
  constexpr int kD = TestFixture::kDimension;
  for (const std::string& name : broad_phase_names<kD>()) {
    const auto run = [&] {
      const auto subject = TestFixture::make(name);
      MovingBoxes<kD> crowd(*subject, 30, 1.5, 11);
      crowd.add(100, 5);
      for (int step = 0; step < 8; ++step) {
        crowd.bounce(0.5);
        subject->step();
      }
      return describe(*subject);
    };
    const StructureParts<kD> a = run();
    const StructureParts<kD> b = run();
    EXPECT_EQ(a.members, b.members) << name;
    EXPECT_EQ(a.tested, b.tested) << name;
    EXPECT_EQ(a.bytes, b.bytes) << name;
    ASSERT_EQ(a.cells.size(), b.cells.size()) << name;
    for (std::size_t k = 0; k < a.cells.size(); ++k) EXPECT_EQ(a.cells[k].name, b.cells[k].name) << name;
  }
}

}  // namespace
}  // namespace kerf::test
