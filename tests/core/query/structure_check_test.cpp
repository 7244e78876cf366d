// Each planted bug of a tree of boxes, and each broken promise of a description, is found and named.

#include "core/query/structure_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "core/query/structure_measures.h"
#include "tests/support/boxes.h"
#include "tests/support/planted_box_tree.h"

namespace kerf::test {
namespace {

using Kind = StructureFaultKind;
using testing::ElementsAre;
using testing::HasSubstr;

/// Twelve boxes in a tree, one of which then moves far away.
class BoxTreeCheck : public testing::Test {
 protected:
  static constexpr StructureLimits kLimits{.depth = 12, .margin = 0.2F};

  void run(TreeBug bug) {
    PlantedBoxTree tree(bug);
    Random random(5);
    for (std::uint32_t id = 0; id < 12; ++id) {
      objects_.push_back({{id}, random_box<2>(random, 10, 0.5)});
      tree.insert({id}, objects_.back().box);
    }
    objects_[3].box = box_at<2>({{20, 20}}, 0.5F);
    tree.move({3}, objects_[3].box);
    tree.describe(parts_);
  }
  std::vector<StructureFault> check(const StructureLimits& limits = kLimits) {
    return check_structure<2>(parts_, objects_, {}, limits);
  }
  static std::set<Kind> kinds_of(const std::vector<StructureFault>& faults) {
    std::set<Kind> kinds;
    for (const StructureFault& fault : faults) kinds.insert(fault.kind);
    return kinds;
  }

  std::vector<KnownObject<2>> objects_;
  StructureParts<2> parts_;
};

TEST_F(BoxTreeCheck, FindsNothingInASoundTree) {
  run(TreeBug::none);
  EXPECT_TRUE(check().empty());
}

TEST_F(BoxTreeCheck, NamesTheNodeWhoseParentWasNotRefitted) {
  run(TreeBug::refit_forgotten);
  const auto faults = check();
  EXPECT_THAT(kinds_of(faults), ElementsAre(Kind::child_outside_parent));
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_THAT(faults[0].text, HasSubstr("lies outside its parent n"));
  EXPECT_THAT(faults[0].text, HasSubstr("along x it ends at 20.75, beyond "));
}

TEST_F(BoxTreeCheck, NamesTheObjectThatWasNotPutInAgain) {
  run(TreeBug::not_reinserted);
  const auto faults = check();
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].kind, Kind::object_in_no_cell);
  EXPECT_EQ(faults[0].object, ObjectId{3});
  EXPECT_EQ(faults[0].text, "object 3 is in no cell");
}

TEST_F(BoxTreeCheck, NamesEachLeafWithoutAMargin) {
  run(TreeBug::no_margin);
  const auto faults = check();
  EXPECT_THAT(kinds_of(faults), ElementsAre(Kind::no_margin));
  EXPECT_EQ(faults.size(), 12U);
  EXPECT_THAT(faults[0].text, HasSubstr("a margin of 0 along x, less than 0.2"));
}

TEST_F(BoxTreeCheck, NamesAChildOfTwoNodesAndTheLeafThatIsLostByIt) {
  run(TreeBug::child_of_two);
  const auto kinds = kinds_of(check());
  EXPECT_TRUE(kinds.contains(Kind::child_of_two));
  EXPECT_TRUE(kinds.contains(Kind::object_in_no_cell));
  EXPECT_TRUE(kinds.contains(Kind::object_in_two_cells));
}

TEST_F(BoxTreeCheck, NamesAnObjectThatLeftItsLeaf) {
  run(TreeBug::none);
  objects_[5].box = box_at<2>({{-20, 0}}, 0.5F);
  const auto faults = check();
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].kind, Kind::object_outside_cell);
  EXPECT_EQ(faults[0].object, ObjectId{5});
  EXPECT_THAT(faults[0].text, HasSubstr("along x it begins at -20.5, before "));
}

TEST_F(BoxTreeCheck, NamesWhatIsTooDeepOrOverlapsTooMuch) {
  run(TreeBug::none);
  EXPECT_TRUE(kinds_of(check({.depth = 2})).contains(Kind::too_deep));
  EXPECT_TRUE(kinds_of(check({.overlap = 0})).contains(Kind::too_much_overlap));
}

TEST_F(BoxTreeCheck, NamesALeafWithoutAnObjectAndAnObjectThatIsNone) {
  run(TreeBug::none);
  const CellMember last = parts_.members.back();
  parts_.members.back().object = {77};
  EXPECT_THAT(kinds_of(check()), ElementsAre(Kind::object_in_no_cell, Kind::unknown_object));
  parts_.members.pop_back();
  EXPECT_THAT(kinds_of(check()), ElementsAre(Kind::object_in_no_cell, Kind::leaf_without_object));
  parts_.members.push_back(last);
  EXPECT_TRUE(check().empty());
}

/// A plane of an engine reaches from one end of the floats to the other: how long it is overflows them.
TEST(StructureCheck, AsksForNoMarginBeyondTheEndsOfTheFloats) {
  constexpr Scalar kMost = std::numeric_limits<Scalar>::max();
  StructureParts<2> parts;
  parts.cells.push_back({{all<2>(-kMost), all<2>(kMost)}, 0, kNoPart, 0, kNoPart});
  parts.members.push_back({0, {0}});
  const std::vector<KnownObject<2>> objects{{{0}, parts.cells[0].box}};
  EXPECT_TRUE(check_structure<2>(parts, objects, {}, {.margin = 0.2F}).empty());
}

/// What is written with few digits may lie outside of its cell by what was rounded away.
TEST(StructureCheck, RoundsAMarginAsItRoundsBounds) {
  StructureParts<2> parts;
  parts.cells.push_back({{{{1, 0}}, {{2.4F, 1.4F}}}, 0, kNoPart, 0, kNoPart});
  parts.members.push_back({0, {0}});
  const std::vector<KnownObject<2>> objects{{{0}, {{{0.999999F, 0.2F}}, {{2, 1.2F}}}}};
  StructureLimits limits{.margin = 0.2F};
  EXPECT_EQ(check_structure<2>(parts, objects, {}, limits).size(), 1U) << "it lies outside";
  limits.tolerance.object.share = 1e-5;
  EXPECT_TRUE(check_structure<2>(parts, objects, {}, limits).empty());
}

/// A cell from 0.9996 to 2.4004 is written with three decimals as one from 1 to 2.4. What both of its ends
/// have lost together counts.
TEST(StructureCheck, AMarginMayLackWhatTheDigitsOfItsCellLeaveOpen) {
  StructureParts<2> parts;
  parts.cells.push_back({{{{1, 0}}, {{2.4F, 1.4F}}}, 0, kNoPart, 0, kNoPart});
  parts.members.push_back({0, {0}});
  std::vector<KnownObject<2>> objects{{{0}, {{{1.1996F, 0.2F}}, {{2.2004F, 1.2F}}}}};
  StructureLimits limits{.margin = 0.2F};
  const auto lacks_margin = [&] {
    const auto faults = check_structure<2>(parts, objects, {}, limits);
    return faults.size() == 1 && faults[0].kind == Kind::no_margin;
  };
  EXPECT_TRUE(lacks_margin()) << "it lacks 0.0004 on each side, and floats are as they are";
  limits.tolerance.object.outer_digits = WrittenDigits{4, 3};
  EXPECT_TRUE(check_structure<2>(parts, objects, {}, limits).empty());
  limits.tolerance.object.outer_digits = WrittenDigits{9, 8};
  EXPECT_TRUE(lacks_margin()) << "so many digits leave nothing open";
  limits.tolerance.object.outer_digits = WrittenDigits{4, 3};
  objects[0].box.min[0] = 1.1992F;
  objects[0].box.max[0] = 2.2008F;
  EXPECT_TRUE(lacks_margin()) << "it lacks 0.0008 on each side";
}

/// Of numbers with one decimal, both distances between two bounds may have been rounded down.
TEST(StructureCheck, AMarginMayLackWhatOneDecimalLeavesOpen) {
  StructureParts<2> parts;
  parts.cells.push_back({{{{20, 0}}, {{21.3F, 1.3F}}}, 0, kNoPart, 0, kNoPart});
  parts.members.push_back({0, {0}});
  const std::vector<KnownObject<2>> objects{{{0}, {{{20.1F, 0.1F}}, {{21.2F, 1.2F}}}}};
  StructureLimits limits{.margin = 0.15F};
  limits.tolerance.object.outer_digits = limits.tolerance.object.inner_digits = WrittenDigits{3, 1};
  EXPECT_TRUE(check_structure<2>(parts, objects, {}, limits).empty());
  limits.margin = 0.3F;
  const auto faults = check_structure<2>(parts, objects, {}, limits);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_THAT(faults[0].text, HasSubstr("a margin of 0.1 along x, less than 0.3"));
}

/// As 2D engines of which the nodes have a third axis.
TEST(StructureCheck, LeavesOutAnAxisAlongWhichAParentIsFlat) {
  const auto flat = [](Scalar low, Scalar high) { return Box<3>{{{low, 0, 0}}, {{high, 4, 0}}}; };
  StructureParts<3> parts;
  parts.cells = {
      {flat(0, 4), 0, kNoPart, 0, kNoPart}, {flat(0, 3), 1, 0, 1, kNoPart}, {flat(2, 4), 2, 0, 1, kNoPart}};
  EXPECT_DOUBLE_EQ(overlap_share(parts, 1, 2), 0.25);
}

/// Two columns, the second from x = 1 on.
StructureParts<2> two_columns() {
  StructureParts<2> parts;
  parts.holding = Holding::reaching;
  parts.cells.assign(2, {everywhere<2>(), 0, kNoPart, 0, kNoPart});
  parts.cells[1].name = 1;
  parts.cells[0].box.max[0] = parts.cells[1].box.min[0] = 1;
  return parts;
}

TEST(StructureCheck, NamesACellThatAnObjectReachesWithoutBeingInIt) {
  StructureParts<2> parts = two_columns();
  const std::vector<KnownObject<2>> objects{{{0}, slab<2>(0, 0.9F)}, {{1}, slab<2>(0.5F, 1)}};
  parts.members = {{0, {0}}, {0, {1}}};
  const auto faults = check_structure<2>(parts, objects, {});
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].kind, Kind::object_not_where_it_reaches);
  EXPECT_EQ(faults[0].text, "object 1 reaches the cell n1, which does not hold it");
  parts.members.push_back({1, {1}});
  EXPECT_TRUE(check_structure<2>(parts, objects, {}).empty());
}

/// Two cells of one size, and one of twice that: each object is in all cells of its own size.
TEST(StructureCheck, NamesAnObjectInACellOfAnotherSize) {
  StructureParts<2> parts = two_columns();
  parts.holding = Holding::of_its_depth;
  parts.cells.push_back({everywhere<2>(), 2, kNoPart, 1, kNoPart});
  const std::vector<KnownObject<2>> objects{{{0}, slab<2>(0, 3)}, {{1}, slab<2>(0.5F, 0.9F)}};
  parts.members = {{2, {0}}, {0, {1}}};
  EXPECT_TRUE(check_structure<2>(parts, objects, {}).empty());
  parts.members = {{2, {0}}, {0, {1}}, {1, {1}}, {2, {1}}};
  const auto faults = check_structure<2>(parts, objects, {});
  ASSERT_EQ(faults.size(), 2U);
  EXPECT_EQ(faults[0].text, "object 1 is in the cell n1, where it does not belong");
  EXPECT_EQ(faults[1].text, "object 1 is in the cell n2, where it does not belong");
  parts.members = {{0, {0}}, {0, {1}}};
  EXPECT_EQ(check_structure<2>(parts, objects, {}).front().text,
            "object 0 reaches the cell n1, which does not hold it");
}

TEST(StructureCheck, FollowsThePlanesThatCutCells) {
  StructureParts<2> parts;
  parts.holding = Holding::reaching;
  parts.cells = {{everywhere<2>(), 0, kNoPart, 0, kNoPart},
                 {everywhere<2>(), 1, 0, 1, 0},
                 {everywhere<2>(), 2, 0, 1, 1}};
  parts.cuts = {{{{{1, 0}}, 1}, false}, {{{{1, 0}}, 1}, true}};
  const std::vector<KnownObject<2>> objects{{{0}, slab<2>(0, 1)}, {{1}, slab<2>(0.5F, 2)}};
  parts.members = {{1, {0}}, {1, {1}}, {2, {1}}};
  EXPECT_TRUE(check_structure<2>(parts, objects, {}).empty());
  parts.members.pop_back();
  EXPECT_EQ(check_structure<2>(parts, objects, {}).size(), 1U);
}

TEST(StructureCheck, NamesAPairThatNothingBringsTogether) {
  StructureParts<2> parts = two_columns();
  const std::vector<KnownObject<2>> objects{{{0}, slab<2>(0, 0.5F)}, {{1}, slab<2>(1, 2)}};
  const std::vector<Pair> pairs{{{0}, {1}}};
  parts.members = {{0, {0}}, {1, {1}}};
  EXPECT_EQ(check_structure<2>(parts, objects, pairs).size(), 1U);  // no cell has both
  parts.tell_tested({0}, {1});
  parts.end_tested();
  EXPECT_TRUE(check_structure<2>(parts, objects, pairs).empty());
  parts.lists.push_back({0, {{0, {0}, false}, {1, {1}, false}}});
  const auto faults = check_structure<2>(parts, objects, pairs);  // in the list they do not meet
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].kind, Kind::pair_never_tested);
}

TEST(StructureCheck, NamesAListOutOfOrderAndAnObjectThatItLacks) {
  StructureParts<2> parts;
  parts.lists.push_back({1, {{2, {0}, false}, {1, {1}, false}}});
  const std::vector<KnownObject<2>> objects{
      {{0}, slab<2>(2, 3, 1)}, {{1}, slab<2>(1, 2, 1)}, {{2}, slab<2>(1, 2, 1)}};
  const auto faults = check_structure<2>(parts, objects, {});
  ASSERT_EQ(faults.size(), 2U);
  EXPECT_EQ(faults[0].text, "the list along y has object 1 at 1 behind 2");
  EXPECT_EQ(faults[1].text, "the list along y has 0 ends of object 2");
}

}  // namespace
}  // namespace kerf::test
