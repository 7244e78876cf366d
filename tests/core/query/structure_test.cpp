// Details of the descriptions of structures (own_broad_phases_test.cpp checks that all are sound).

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/broad_phase/describe.h"
#include "core/bsp/bsp.h"
#include "core/query/structure_measures.h"
#include "core/related/multi_level_hash.h"
#include "core/related/rebuilt_tree.h"
#include "core/related/sphere_tree.h"
#include "tests/support/moving_boxes.h"

namespace kerf::test {
namespace {

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
