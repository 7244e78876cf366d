#include "viz/draw/crowds.h"

#include <gtest/gtest.h>

#include "tests/support/dimensions.h"
#include "tests/viz/small_scene.h"

namespace kerf {
namespace {

template <class T>
class Crowds : public testing::Test {};
TYPED_TEST_SUITE(Crowds, test::Dimensions, test::DimensionNames);

TYPED_TEST(Crowds, HoldTheObjectsOfEachNodeAndLieWithinTheBounds) {
  constexpr int kD = TypeParam::value;
  const test::SmallScene<kD> scene;
  const Box<kD> bounds{test::all<kD>(-20), test::all<kD>(32)};
  const auto crowds = find_crowds<kD>(scene.tree(), scene.bodies(), bounds);
  std::size_t tight = 0;
  for_each_node(scene.tree(), scene.tree().root(), [&](NodeId id) {
    const Box<kD>& crowd = crowd_of<kD>(crowds, id, bounds);
    EXPECT_TRUE(contains(bounds, crowd));
    const NodeId parent = scene.tree()[id].parent;
    if (!parent.is_none()) {
      EXPECT_TRUE(contains(crowd_of<kD>(crowds, parent, bounds), crowd));
    }
    for (const Entry& entry : scene.tree()[id].entries)
      EXPECT_TRUE(contains(crowd, scene.bodies()[entry.object.index()].box));
    tight += crowd.extent()[0] < 0.5F * bounds.extent()[0] ? 1 : 0;
  });
  EXPECT_GT(tight, 3U) << "they are no larger than they must be";
}

TYPED_TEST(Crowds, ANodeWithoutObjectsHasAllOfTheBounds) {
  constexpr int kD = TypeParam::value;
  const Tree<kD> tree = test::SmallScene<kD>(0).tree();
  const Box<kD> bounds{test::all<kD>(1), test::all<kD>(2)};
  EXPECT_EQ(find_crowds<kD>(tree, {}, bounds)[tree.root().index()], bounds);
  EXPECT_EQ(crowd_of<kD>({}, tree.root(), bounds), bounds);
}

TYPED_TEST(Crowds, StraysOutsideAreCutOff) {
  constexpr int kD = TypeParam::value;
  const test::SmallScene<kD> scene;
  const Box<kD> bounds{test::all<kD>(3), test::all<kD>(6)};
  const auto crowds = find_crowds<kD>(scene.tree(), scene.bodies(), bounds);
  EXPECT_EQ(crowds[scene.tree().root().index()], bounds);
}

}  // namespace
}  // namespace kerf
