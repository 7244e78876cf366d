#include "core/tree/placement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/tree/hash.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/pairs.h"
#include "tests/support/planted_tree.h"
#include "tests/support/sound.h"

namespace kerf::test {
namespace {

template <class T>
class Placement : public testing::Test {};
TYPED_TEST_SUITE(Placement, Dimensions, DimensionNames);

TYPED_TEST(Placement, PlacesAnObjectInEveryLeafThatItReaches) {
  constexpr int kD = TypeParam::value;
  auto tree = tree_of<kD>(std::vector{slab<kD>(0, 1)});
  plant(tree, tree.root(), 0, 5);
  plant(tree, tree[tree.root()].left, 0, 3);
  ASSERT_EQ(tree.table.insert({1}, slab<kD>(2, 6), Mobility::moving), Status::ok);
  EXPECT_EQ(place(tree, tree.root(), {1}, 0), 3U);
  ASSERT_EQ(tree.table.insert({2}, slab<kD>(5, 5), Mobility::moving), Status::ok);
  EXPECT_EQ(place(tree, tree.root(), {2}, 0), 1U);
  sort_phase(tree);
  EXPECT_TRUE(is_sound(tree));
}

TYPED_TEST(Placement, BoxesReachAlikeIfTheyReachTheSameLeavesOnTheSameSides) {
  constexpr int kD = TypeParam::value;
  Random random(4);
  int alike = 0;
  for (int round = 0; round < 400; ++round) {
    const auto tree = random_tree<TypeParam::value>(random, 40, 5, 12, 9);
    const Box<kD> first = random_box<kD>(random, 20, 3);
    const auto by = static_cast<Scalar>(random.uniform(-4, 4));
    const Box<kD> second{first.min + all<kD>(by), first.max + all<kD>(by)};
    std::vector<Reached> of_first;
    std::vector<Reached> of_second;
    std::vector<NodeId> passed;
    reach(tree, first, of_first, passed);
    const std::size_t passed_by_first = passed.size();
    reach(tree, second, of_second, passed);
    std::vector<NodeId> leaves;
    ASSERT_EQ(reach_alike(tree, first, second, leaves), of_first == of_second) << round;
    if (of_first != of_second) continue;
    ++alike;
    const auto half = passed.begin() + static_cast<std::ptrdiff_t>(passed_by_first);
    ASSERT_TRUE(std::equal(passed.begin(), half, half, passed.end())) << round;
    ASSERT_TRUE(std::ranges::equal(leaves, of_first, {}, {}, &Reached::leaf)) << round;
  }
  EXPECT_GT(alike, 50);
  EXPECT_LT(alike, 350);
}

TYPED_TEST(Placement, DisplacedObjectsLeaveEveryLeafAndReturn) {
  Random random(1);
  for (int round = 0; round < 30; ++round) {
    auto tree = random_tree<TypeParam::value>(random, 40, 5, 12, 9);
    const std::uint64_t before = hash(tree);
    const std::vector<ObjectId> some{{3}, {17}, {0}, {39}};
    displace<TypeParam::value>(tree, tree.root(), some);
    for (const ObjectId object : objects_below(tree, tree.root()))
      EXPECT_EQ(std::count(some.begin(), some.end(), object), 0);
    EXPECT_EQ(tree.objects(), 36U);
    for (const ObjectId object : some) place(tree, tree.root(), object, 0);
    sort_phase(tree);
    ASSERT_TRUE(is_sound(tree));
    ASSERT_EQ(hash(tree), before);
  }
}

TYPED_TEST(Placement, ManyDisplacedAtOnceLeaveTheTreeThatEachForItselfLeaves) {
  constexpr int kD = TypeParam::value;
  Random random(5);
  for (int round = 0; round < 30; ++round) {
    auto tree = random_tree<TypeParam::value>(random, 40, 5, 12, 9);
    const std::vector<NodeId> inner = inner_nodes(tree);
    const NodeId from = inner[random.below(static_cast<std::uint32_t>(inner.size()))];
    auto one_by_one = tree;
    std::vector<ObjectId> some = objects_below(tree, from);
    some.resize(some.size() / 2);  // too many to walk for each
    displace<kD>(tree, from, some);
    for (const ObjectId object : some) {
      std::vector<NodeId> passed;
      for_each_node(one_by_one, from, [&](NodeId id) {
        const std::vector<ObjectId> below = objects_below(one_by_one, id);
        if (std::ranges::find(below, object) != below.end()) passed.push_back(id);
      });
      const Departure departure{{&object, 1}, passed};
      TaskPool alone;
      displace<kD>(one_by_one, {&departure, 1}, alone);
    }
    ASSERT_EQ(hash(tree), hash(one_by_one)) << round;
  }
}

TYPED_TEST(Placement, DisplacingOneObjectLeavesThoseDisplacedBeforeAlone) {
  constexpr int kD = TypeParam::value;
  auto tree = tree_of<kD>(std::vector{slab<kD>(0, 1), slab<kD>(0, 1)});
  for (const std::uint32_t k : {0U, 1U}) {
    const std::vector<ObjectId> one{{k}};
    displace<kD>(tree, tree.root(), one);
    place(tree, tree.root(), {k}, 0);
  }
  EXPECT_EQ(objects_below(tree, tree.root()), (std::vector<ObjectId>{{0}, {1}}));
}

TYPED_TEST(Placement, WalksTheDeepestTree) {
  constexpr int kD = TypeParam::value;
  auto tree = tree_of<kD>(std::vector<Box<kD>>{});
  NodeId leaf = tree.root();
  for (std::uint32_t depth = 0; depth < kMaxHeight; ++depth) {
    plant(tree, leaf, 0, static_cast<Scalar>(depth));
    leaf = depth % 2 == 0 ? tree[leaf].right : tree[leaf].left;
  }
  ASSERT_EQ(tree.table.insert({0}, slab<kD>(-10, 100), Mobility::moving), Status::ok);
  EXPECT_EQ(place(tree, tree.root(), {0}, 0), kMaxHeight + 1) << "on both sides of all planes";
  EXPECT_TRUE(is_sound(tree));
  EXPECT_EQ(collect(tree, tree.root()).size(), 1U);
  const std::vector<ObjectId> only{{0}};
  displace<kD>(tree, tree.root(), only);
  ASSERT_EQ(tree.table.remove({0}), Status::ok);
  EXPECT_EQ(tree.entries(), 0U);
  EXPECT_TRUE(is_sound(tree));
}

TYPED_TEST(Placement, StaysAgreesWithPlacingAnew) {
  constexpr int kD = TypeParam::value;
  Random random(2);
  int stayed = 0;
  for (int round = 0; round < 300; ++round) {
    auto tree = random_tree<TypeParam::value>(random, 40, 2, 12, 9);
    const ObjectId object{random.below(40)};
    Box<kD> box = tree.table.box(object);
    const Vector<kD> shift = random_point<kD>(random, -0.5, 0.5);
    box = {box.min + shift, box.max + shift};
    auto anew = tree;
    const std::vector<ObjectId> one{object};
    displace<kD>(anew, anew.root(), one);
    ASSERT_EQ(anew.table.move(object, box), Status::ok);
    place(anew, anew.root(), object, 0);
    sort_phase(anew);
    const std::uint64_t before = hash(tree);
    const bool stays_put = try_keep_in_leaves(tree, object, make_box_volume(box));
    ASSERT_EQ(hash(tree), before) << "entries and table are as they were";
    if (!stays_put) {
      // Somewhere the object changed sides: its masks or leaves differ.
      ASSERT_EQ(tree.table.move(object, box), Status::ok);
      for_each_node(tree, tree.root(), [&](NodeId id) { tree[id].unsorted = tree[id].is_leaf(); });
      sort_phase(tree);
      ASSERT_NE(hash(tree), hash(anew));
      continue;
    }
    ++stayed;
    ASSERT_EQ(tree.table.move(object, box), Status::ok);
    sort_phase(tree);
    ASSERT_TRUE(is_sound(tree)) << "the leaves that hold it were marked for the sort";
    ASSERT_EQ(hash(tree), hash(anew));
  }
  EXPECT_GT(stayed, 50);
  EXPECT_LT(stayed, 250);
}

TYPED_TEST(Placement, CollectGivesEachObjectOnceWithItsBitsAbove) {
  Random random(3);
  for (int round = 0; round < 30; ++round) {
    auto tree = random_tree<TypeParam::value>(random, 40, 5, 12, 9);
    for_each_node(tree, tree.root(), [&](NodeId from) {
      const auto stored = collect(tree, from);
      std::vector<ObjectId> objects;
      for (const Stored& item : stored) {
        objects.push_back(item.object);
        EXPECT_EQ(item.above & ~bits_above(tree[from].depth), 0U);
        for (NodeId up = tree[from].parent; !up.is_none(); up = tree[up].parent) {
          const Sides sides = classify(tree.project(tree[up].direction, item.object), tree[up].plane.offset);
          EXPECT_EQ((item.above & depth_bit(tree[up].depth)) != 0, sides.straddle());
        }
      }
      std::sort(objects.begin(), objects.end());
      ASSERT_EQ(objects, objects_below(tree, from));
      ASSERT_EQ(objects.size(), tree[from].population);
    });
  }
}

}  // namespace
}  // namespace kerf::test
