// Another engine's nodes as a structure: whatever is wrong with their links is named, and the rest is drawn
// and checked all the same.

#include "core/query/their_parts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "core/query/explain_their_search.h"
#include "tests/support/boxes.h"

namespace kerf::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// Two leaves below a root: objects 0 and 1, from 0 to 1 and from 0.5 to 1.5.
class TheirPartsTest : public testing::Test {
 protected:
  TheirPartsTest() {
    add(100, {}, slab<2>(0, 1.5F), {});
    add(7, GivenId::of(100), slab<2>(0, 1), {{0}});
    add(9, GivenId::of(100), slab<2>(0.5F, 1.5F), {{1}});
    static_cast<void>(objects_.insert({0}, slab<2>(0, 1), Mobility::moving));
    static_cast<void>(objects_.insert({1}, slab<2>(0.5F, 1.5F), Mobility::moving));
  }
  void add(std::uint32_t name, std::optional<GivenId> parent, const Box<2>& box,
           std::vector<ObjectId> objects) {
    structure_.nodes.push_back({GivenId::of(name), parent, box, std::move(objects), std::nullopt, 0});
  }
  [[nodiscard]] std::vector<std::string> faults(const StructureLimits& limits = {},
                                                const TheirPast<2>& past = {}) const {
    std::vector<std::string> texts;
    for (const StructureFault& fault : check_theirs<2>(structure_, objects_, {}, past, limits))
      texts.push_back(std::string(to_string(fault.kind)) + ": " + fault.text);
    return texts;
  }
  [[nodiscard]] std::string search(const GivenNames& names = {}) const {
    return explain_their_search<2>(structure_, objects_, {{0}, {1}}, names);
  }

  TheirStructure<2> structure_;
  ObjectTable<2> objects_;
};

TEST_F(TheirPartsTest, NothingIsWrongWithASoundTree) {
  EXPECT_THAT(faults(), IsEmpty());
  const StructureParts<2> parts = parts_of(structure_).parts;
  ASSERT_EQ(parts.cells.size(), 3U);
  EXPECT_EQ(parts.cells[2].parent, 0U);
  EXPECT_EQ(parts.cells[2].depth, 1U);
  EXPECT_EQ(parts.members, (std::vector<CellMember>{{1, {0}}, {2, {1}}}));
}

/// Lines may stand in any order.
TEST_F(TheirPartsTest, ParentsStandBeforeTheirChildren) {
  std::ranges::reverse(structure_.nodes);
  EXPECT_THAT(faults(), IsEmpty());
  EXPECT_EQ(node_name(structure_, parts_of(structure_).parts.cells[0].name), "n100");
}

TEST_F(TheirPartsTest, ANodeWithTwoParentsIsNamed) {
  add(11, GivenId::of(100), slab<2>(0, 1), {});
  add(7, GivenId::of(11), slab<2>(0, 1), {{0}});
  EXPECT_THAT(faults(), ElementsAre("child of two nodes: n7 is a child of n100 and of n11",
                                    "object in two cells: object 0 is in 2 cells"));
}

TEST_F(TheirPartsTest, ANodeWhoseParentIsNoneIsLost) {
  structure_.nodes[1].parent = GivenId::of(55);
  EXPECT_THAT(faults(), ElementsAre("node lost: n7 is lost: its parent n55 is no node"));
}

TEST_F(TheirPartsTest, NodesThatHangBelowThemselvesAreLost) {
  structure_.nodes[1].parent = GivenId::of(9);
  structure_.nodes[2].parent = GivenId::of(7);
  const auto texts = faults();
  EXPECT_THAT(texts, testing::Contains("node lost: n7 is lost: it hangs below itself, and no way leads to it "
                                       "from a root"));
}

/// A leaf that hangs below a circle stays there, and a node of the circle is named.
TEST_F(TheirPartsTest, ACircleIsNamedByOneOfItsNodes) {
  structure_.nodes.resize(1);
  add(5, GivenId::of(7), slab<2>(0, 1.5F), {{0}});
  add(7, GivenId::of(9), slab<2>(0, 1.5F), {});
  add(9, GivenId::of(7), slab<2>(0, 1.5F), {{1}});
  EXPECT_THAT(faults(), ElementsAre("node lost: n7 is lost: it hangs below itself, and no way leads to it "
                                    "from a root"));
  const StructureParts<2> parts = parts_of(structure_).parts;
  ASSERT_EQ(parts.cells.size(), 4U);
  EXPECT_EQ(node_name(structure_, parts.cells[2].name), "n5");
  EXPECT_EQ(parts.cells[2].parent, 1U);
}

TEST_F(TheirPartsTest, ALeafWithoutAnObjectIsNamedIfItIsCalledALeafOrIfMostHoldOne) {
  add(11, GivenId::of(100), slab<2>(0, 1), {});
  EXPECT_THAT(faults(), ElementsAre("leaf without an object: the leaf n11 holds no object"));
  structure_.nodes[3].leaf = false;
  EXPECT_THAT(faults(), IsEmpty());
  structure_.nodes[3].leaf = std::nullopt;
  add(12, GivenId::of(100), slab<2>(0, 1), {});
  EXPECT_THAT(faults(), IsEmpty());
  structure_.nodes[3].leaf = true;
  EXPECT_THAT(faults(), ElementsAre("leaf without an object: the leaf n11 holds no object"));
}

TEST_F(TheirPartsTest, AnEmptyTreeLacksItsObjectsAndNothingElse) {
  structure_.nodes.resize(1);
  const auto lost =
      ElementsAre("object in no cell: object 0 is in no cell", "object in no cell: object 1 is in no cell");
  EXPECT_THAT(faults(), lost) << "a root alone is no leaf without an object";
  structure_.nodes.clear();
  EXPECT_THAT(faults(), lost);
}

TEST_F(TheirPartsTest, AnObjectThatANodeNamesTwiceIsInItOnce) {
  structure_.nodes[1].objects = {{0}, {0}};
  EXPECT_THAT(faults(), IsEmpty());
}

/// It has a box that cannot be placed, and it is there all the same.
TEST_F(TheirPartsTest, AnObjectInQuarantineIsKnown) {
  static_cast<void>(objects_.insert({2}, slab<2>(3, 2), Mobility::moving));
  add(8, GivenId::of(100), slab<2>(0, 1), {{2}});
  EXPECT_THAT(faults(), IsEmpty());
  static_cast<void>(objects_.remove({2}));
  EXPECT_THAT(faults(), ElementsAre("unknown object: n8 holds object 2, which is no object"));
}

TEST_F(TheirPartsTest, WhatTheEngineCallsALeafHasNoChildren) {
  structure_.nodes[0].leaf = structure_.nodes[1].leaf = true;
  EXPECT_THAT(faults(), ElementsAre("leaf with children: n100 is called a leaf, and has the child n7"));
}

TEST_F(TheirPartsTest, AMarginThatIsClaimedIsJudgedWhereALeafWasPlacedAnew) {
  TheirStructure<2> before = structure_;
  structure_.nodes[1].margin = 0.1F;
  EXPECT_THAT(faults(), IsEmpty()) << "in the first step all leaves are new";
  EXPECT_THAT(faults({}, {&before, true, false}), IsEmpty()) << "it stayed: its object may have turned";
  before.nodes[1].box.max[0] = 0.9F;
  EXPECT_THAT(faults({}, {&before, true, false}),
              ElementsAre("no margin: n7 leaves object 0 a margin of 0 along x, less than 0.1"));
  EXPECT_THAT(faults({}, {&before, false, false}), IsEmpty()) << "its object may have turned in between";
  before.nodes[1].objects.front() = {1};
  EXPECT_THAT(faults({}, {&before, true, false}), IsEmpty()) << "it was the leaf of another object";
  before.nodes[1].name = GivenId::of(70);
  EXPECT_THAT(faults({}, {&before, true, false}), IsEmpty()) << "it is new";
  before = structure_;
  structure_.nodes[1].box = slab<2>(-0.1F, 1.1F);
  structure_.nodes[1].box.min[1] -= 0.1F;
  structure_.nodes[1].box.max[1] += 0.1F;
  structure_.nodes[0].box = join(structure_.nodes[0].box, structure_.nodes[1].box);
  EXPECT_THAT(faults({}, {&before, true, false}), IsEmpty());
}

TEST_F(TheirPartsTest, AMarginThatIsAskedForIsJudgedInNewLeavesToo) {
  const StructureLimits limits{.margin = 0.1F};
  EXPECT_THAT(faults(limits), ElementsAre(HasSubstr("no margin: n7"), HasSubstr("no margin: n9")));
  TheirStructure<2> before = structure_;
  EXPECT_THAT(faults(limits, {&before, true, false}), IsEmpty());
  before.nodes[1].box.max[0] = 0.9F;
  EXPECT_THAT(faults(limits, {&before, true, false}), ElementsAre(HasSubstr("no margin: n7")));
  before = structure_;
  before.nodes.pop_back();
  EXPECT_THAT(faults(limits, {&before, true, false}), ElementsAre(HasSubstr("no margin: n9")));
}

/// A child and its parent were written alike, an object and its cell need not have been.
TEST_F(TheirPartsTest, DigitsSayWhatBoundsMayBeOff) {
  structure_.nodes[1].box.max[0] = 0.9999F;
  EXPECT_THAT(faults(), ElementsAre(HasSubstr("object outside its cell: object 0")));
  structure_.digits = TheirDigits{{9, 0}, {4, 3}};
  EXPECT_THAT(faults(), IsEmpty());
  structure_.digits = TheirDigits{{9, 0}, {9, 0}};
  EXPECT_THAT(faults(), ElementsAre(HasSubstr("object outside its cell: object 0")));
  structure_.digits = TheirDigits{{9, 0}, {4, 3}};
  structure_.nodes[0].box.max[0] = 1.4999F;
  EXPECT_THAT(faults(), ElementsAre(HasSubstr("child outside its parent: n9")));
}

TEST_F(TheirPartsTest, DepthAndOverlapHaveBoundsIfOneGivesThem) {
  EXPECT_THAT(faults({.depth = 0}), testing::SizeIs(2));
  EXPECT_THAT(faults({.overlap = 0.1}), ElementsAre(HasSubstr("too much overlap: the children n7 and n9")));
}

/// Fixed objects are judged if any of them is part of the structure.
TEST_F(TheirPartsTest, FixedObjectsMayLiveElsewhere) {
  static_cast<void>(objects_.insert({2}, slab<2>(4, 5), Mobility::fixed));
  static_cast<void>(objects_.insert({3}, slab<2>(1, 1.2F), Mobility::fixed));
  EXPECT_THAT(faults(), IsEmpty());
  EXPECT_THAT(faults({}, {nullptr, false, true}), testing::SizeIs(2)) << "the tree has held fixed ones";
  structure_.nodes[2].objects.push_back({3});
  EXPECT_THAT(faults(), ElementsAre("object in no cell: object 2 is in no cell"));
}

TEST_F(TheirPartsTest, SearchesThatFindAPairSayThatItWasLostLater) {
  EXPECT_THAT(search(), HasSubstr("a search with the box of n7 for object 1 finds it"));
  EXPECT_THAT(search(), HasSubstr("if the pair was missed, it was lost behind them"));
}

TEST_F(TheirPartsTest, AFaultIsNamedThoughTheSearchFindsThePair) {
  structure_.nodes[1].box.max[0] = 0.9F;
  EXPECT_THAT(search(), HasSubstr("it was lost behind them"));
  EXPECT_THAT(search(), HasSubstr("the fault: object 0 lies outside its node n7: along x it ends at 1, "
                                  "beyond 0.9. It was not put in again\n"));
}

TEST_F(TheirPartsTest, ASearchBlamesNoNodeForWhatItsDigitsLeaveOpen) {
  const auto is_named =
      HasSubstr("the fault: object 0 lies outside its node n7: along x it ends at 1, beyond ");
  const auto is_none = Not(HasSubstr("the fault"));
  structure_.nodes[1].box.max[0] = 0.9999F;
  EXPECT_THAT(search(), is_named) << "six digits, since it is not known how many";
  structure_.digits = TheirDigits{{9, 0}, {4, 3}};
  EXPECT_THAT(search(), is_none);
  structure_.nodes[1].box.max[0] = 0.999F;
  EXPECT_THAT(search(), is_named) << "more than three decimals leave open";
  structure_.nodes[1].box.max[0] = 0.999995F;
  structure_.digits = TheirDigits{{9, 0}, {9, 0}};
  EXPECT_THAT(search(), is_named) << "nine digits show it";
  structure_.digits = std::nullopt;
  EXPECT_THAT(search(), is_none) << "six digits do not";
}

/// A child and its parent were written alike, however many digits they have.
TEST_F(TheirPartsTest, ASearchBlamesAParentForMoreThanRoundingFloats) {
  const auto is_named =
      HasSubstr("the fault: n9 lies outside its parent n100: along x it ends at 1.5, beyond ");
  const auto is_none = Not(HasSubstr("the fault"));
  structure_.nodes[0].box.max[0] = 1.49999F;
  EXPECT_THAT(search(), is_none) << "six digits, since it is not known how many";
  structure_.digits = TheirDigits{{9, 0}, {4, 3}};
  EXPECT_THAT(search(), is_named);
  structure_.nodes[0].box.max[0] = std::nextafter(1.5F, 0.0F);
  EXPECT_THAT(search(), is_none) << "the next float";
  structure_.digits = std::nullopt;
  structure_.nodes[0].box.max[0] = 1.4999F;
  EXPECT_THAT(search(), is_named) << "six digits show it";
}

TEST_F(TheirPartsTest, ASearchFindsAnObjectInAnyOfItsNodes) {
  structure_.nodes[0].box.min[0] = -9;
  structure_.nodes[1].box = slab<2>(-9, -8);
  add(8, GivenId::of(100), slab<2>(0, 1), {{0}});
  EXPECT_THAT(search(), HasSubstr("object 0 is in n8 at depth 1"));
  EXPECT_THAT(search(), HasSubstr("a search with the box of n9 for object 0 finds it"));
  EXPECT_THAT(search(), HasSubstr("a search with the box of n8 for object 1 finds it"));
}

TEST_F(TheirPartsTest, ASearchEndsAtTheNodeThatWasNotRefitted) {
  structure_.nodes[0].box.max[0] = 0.4F;
  EXPECT_THAT(search(), HasSubstr("a search with the box of n9 for object 0 ends at n100 at depth 0"));
  EXPECT_THAT(search(), HasSubstr("the fault: n7 lies outside its parent n100: along x it ends at 1, beyond "
                                  "0.4. A refit was forgotten"));
}

TEST_F(TheirPartsTest, ASearchEndsAtTheLeafThatItsObjectHasLeft) {
  structure_.nodes[1].box = slab<2>(0, 0.3F);
  const GivenNames names({GivenId::of(40), GivenId::of(41)}, {});
  EXPECT_THAT(search(names), HasSubstr("a search with the box of n9 for object 40 ends at n7 at depth 1"));
  EXPECT_THAT(search(names), HasSubstr("the fault: object 40 lies outside its node n7: along x it ends at 1, "
                                       "beyond 0.3. It was not put in again"));
}

TEST_F(TheirPartsTest, AnObjectInNoNodeIsFoundByNoSearch) {
  structure_.nodes.pop_back();
  EXPECT_THAT(search(), HasSubstr("object 1 is in no node: its leaf is lost, or was not put in again"));
  EXPECT_THAT(search(), Not(HasSubstr("for object 1")));
}

}  // namespace
}  // namespace kerf::test
