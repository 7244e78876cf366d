#include "core/tree/split.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/tree/hash.h"
#include "core/tree/merge.h"
#include "tests/support/boxes.h"
#include "tests/support/config_of.h"
#include "tests/support/dimensions.h"
#include "tests/support/pairs.h"
#include "tests/support/planted_tree.h"
#include "tests/support/sound.h"

namespace kerf::test {
namespace {

template <class T>
class Split : public testing::Test {
 protected:
  static constexpr int kSize = T::value;

  static std::vector<Box<kSize>> scattered(std::uint32_t count, double half, std::uint64_t seed = 1) {
    Random random(seed);
    std::vector<Box<kSize>> boxes;
    for (std::uint32_t k = 0; k < count; ++k) boxes.push_back(random_box<kSize>(random, 50, half));
    return boxes;
  }

  /// Splits the root and expects to be refused without a trace.
  static void expect_refused(kerf::Tree<kSize>& tree, const Config& config, Refusal expected) {
    const std::uint64_t before = hash(tree);
    Refusal refusal{};
    EXPECT_FALSE(split(tree, tree.root(), config, refusal));
    EXPECT_EQ(to_string(refusal), to_string(expected));
    EXPECT_EQ(hash(tree), before);
  }
};
TYPED_TEST_SUITE(Split, Dimensions, DimensionNames);

TYPED_TEST(Split, KeepsEveryObject) {
  constexpr int kD = TypeParam::value;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    auto tree = tree_of<kD>(this->scattered(100, 3, seed));
    const auto objects = objects_below(tree, tree.root());
    Refusal refusal{};
    ASSERT_TRUE(split(tree, tree.root(), config_of("max_redundancy=0.5"), refusal));
    sort_phase(tree);
    EXPECT_FALSE(tree[tree.root()].is_leaf());
    EXPECT_TRUE(is_sound(tree));
    EXPECT_EQ(objects_below(tree, tree.root()), objects);
    EXPECT_TRUE(same_pairs(swept(tree), overlapping(tree)));
  }
}

TYPED_TEST(Split, StoresStraddlersOnBothSides) {
  constexpr int kD = TypeParam::value;
  auto tree = tree_of<kD>(std::vector{slab<kD>(0, 1), slab<kD>(1, 2), slab<kD>(0.5F, 1.5F), slab<kD>(1, 1)});
  const Quality quality = divide(tree, tree.root(), 0, 1);
  EXPECT_EQ(quality, (Quality{4, 4, 2})) << "lo <= d is left, hi > d is right";
  const auto& root = tree[tree.root()];
  EXPECT_EQ(objects_below(tree, root.left), (std::vector<ObjectId>{{0}, {1}, {2}, {3}}));
  EXPECT_EQ(objects_below(tree, root.right), (std::vector<ObjectId>{{1}, {2}}));
  EXPECT_EQ(tree.entries(), 6U);
  sort_phase(tree);
  EXPECT_TRUE(is_sound(tree));
}

TYPED_TEST(Split, ReportsWhatItDid) {
  constexpr int kD = TypeParam::value;
  auto tree = tree_of<kD>(this->scattered(60, 1));
  const NodeRef root = tree.ref(tree.root());
  const auto candidate = choose_partitioner(tree, tree.root(), Config{});
  Refusal refusal{};
  const auto event = split(tree, tree.root(), Config{}, refusal);
  ASSERT_TRUE(event && candidate);
  EXPECT_EQ(event->op, Operator::split);
  EXPECT_EQ(event->node, root) << "the node lives on";
  EXPECT_EQ(event->before, (Quality{60, 0, 0}));
  EXPECT_EQ(event->after, candidate->quality);
  EXPECT_EQ(event->after, measure(shadows(tree, event->direction), event->new_offset));
  EXPECT_EQ(event->direction, candidate->direction);
  const auto& node = tree[tree.root()];
  EXPECT_EQ(node.plane, (Plane<kD>{tree.directions()[event->direction], event->new_offset}));
  EXPECT_EQ(node.direction, event->direction);
}

TYPED_TEST(Split, MakesANodeThatIsGood) {
  constexpr int kD = TypeParam::value;
  for (const char* text : {"", "max_redundancy=0.1", "min_balance=0.9,max_redundancy=0.3", "sample=8"}) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      auto tree = tree_of<kD>(this->scattered(80, 1, seed));
      Refusal refusal{};
      const auto event = split(tree, tree.root(), config_of(text), refusal);
      if (event) {
        EXPECT_TRUE(is_good(event->after, config_of(text))) << text;
      } else {
        EXPECT_EQ(refusal, Refusal::no_partitioner);
      }
    }
  }
}

TYPED_TEST(Split, IsUndoneByMerge) {
  constexpr int kD = TypeParam::value;
  auto tree = tree_of<kD>(this->scattered(100, 3));
  const auto objects = objects_below(tree, tree.root());
  Refusal refusal{};
  ASSERT_TRUE(split(tree, tree.root(), config_of("max_redundancy=0.5"), refusal));
  ASSERT_GT(tree.entries(), 100U) << "some straddle";
  merge(tree, tree.root());
  sort_phase(tree);
  EXPECT_TRUE(tree[tree.root()].is_leaf());
  EXPECT_EQ(tree.entries(), 100U);
  EXPECT_EQ(objects_below(tree, tree.root()), objects);
  EXPECT_TRUE(is_sound(tree));
}

TYPED_TEST(Split, RefusesWhereEverythingCoincides) {
  auto tree = tree_of<TypeParam::value>(std::vector(40, slab<TypeParam::value>(0, 1)));
  this->expect_refused(tree, Config{}, Refusal::no_partitioner);
  this->expect_refused(tree, config_of("min_balance=0,max_redundancy=1"), Refusal::no_partitioner);
}

TYPED_TEST(Split, RefusesWhenEveryPlaneIsStraddled) {
  constexpr int kD = TypeParam::value;
  std::vector<Box<kD>> nested;
  for (int k = 1; k <= 40; ++k) nested.push_back(box_at(all<kD>(0), static_cast<Scalar>(k)));
  auto tree = tree_of<kD>(nested);
  this->expect_refused(tree, Config{}, Refusal::no_partitioner);
}

TYPED_TEST(Split, RefusesWhatIsNotBalanced) {
  constexpr int kD = TypeParam::value;
  std::vector<Box<kD>> lopsided(30, slab<kD>(0, 1));
  for (int k = 0; k < 10; ++k) lopsided.push_back(slab<kD>(5, 6));
  auto tree = tree_of<kD>(lopsided);
  this->expect_refused(tree, Config{}, Refusal::no_partitioner);
  Refusal refusal{};
  EXPECT_TRUE(split(tree, tree.root(), config_of("min_balance=0.25"), refusal)) << "10 : 30";
}

TYPED_TEST(Split, RefusesAtTheHeightCap) {
  constexpr int kD = TypeParam::value;
  auto tree = tree_of<kD>(this->scattered(60, 0.1));
  this->expect_refused(tree, config_of("max_height=0"), Refusal::height);
  plant(tree, tree.root(), 0, 25);
  const NodeId child = tree[tree.root()].left;
  Refusal refusal{};
  EXPECT_FALSE(split(tree, child, config_of("max_height=1,min_balance=0"), refusal));
  EXPECT_EQ(refusal, Refusal::height);
  EXPECT_TRUE(split(tree, child, config_of("max_height=2,min_balance=0"), refusal));
}

TYPED_TEST(Split, NeverGoesDeeperThanMasksReach) {
  constexpr int kD = TypeParam::value;
  std::vector<Box<kD>> halving;  // each plane parts one object from the rest
  for (int k = 0; k < 80; ++k) halving.push_back(slab<kD>(std::ldexp(1.0F, k), std::ldexp(1.5F, k)));
  auto tree = tree_of<kD>(halving);
  const Config config = config_of("max_height=63,min_balance=0,free_directions=0");
  Refusal refusal{};
  NodeId leaf = tree.root();
  for (int depth = 0; depth < 63; ++depth) {
    plant(tree, leaf, 0, std::ldexp(1.7F, 79 - depth - 1));
    ASSERT_TRUE(is_sound(tree));
    leaf = tree[leaf].left;
  }
  EXPECT_EQ(tree[leaf].depth, kMaxHeight);
  EXPECT_FALSE(split(tree, leaf, config, refusal));
  EXPECT_EQ(refusal, Refusal::height);
  EXPECT_TRUE(same_pairs(swept(tree), overlapping(tree)));
}

TYPED_TEST(Split, RefusesAtTheCapOnEntries) {
  constexpr int kD = TypeParam::value;
  auto tree = tree_of<kD>(this->scattered(60, 3));
  this->expect_refused(tree, config_of("max_entries=1,max_redundancy=0.5,min_balance=0.9"), Refusal::entries);
  Refusal refusal{};
  EXPECT_TRUE(split(tree, tree.root(), config_of("max_entries=1.5,max_redundancy=0.5"), refusal));
  EXPECT_LE(static_cast<float>(tree.entries()), 1.5F * 60);
}

TYPED_TEST(Split, AllowsExactlyAsManyEntriesAsTheCap) {
  constexpr int kD = TypeParam::value;
  const auto tree = tree_of<kD>(this->scattered(10, 1));
  const Config config = config_of("max_entries=1.5");
  EXPECT_FALSE(forbids_division(tree, tree.root(), 5, config));
  EXPECT_EQ(forbids_division(tree, tree.root(), 6, config), Refusal::entries);
}

TYPED_TEST(Split, ForgetsEarlierRefusals) {
  constexpr int kD = TypeParam::value;
  auto tree = tree_of<kD>(this->scattered(60, 0.5));
  tree[tree.root()].refusals = 3;
  tree[tree.root()].retry_step = 1000;
  Refusal refusal{};
  ASSERT_TRUE(split(tree, tree.root(), Config{}, refusal));
  merge(tree, tree.root());
  EXPECT_EQ(tree[tree.root()].refusals, 0U);
  EXPECT_EQ(tree[tree.root()].retry_step, 0U);
}

TYPED_TEST(Split, AlongTheSameNormalKeepsTheOrder) {
  constexpr int kD = TypeParam::value;
  auto tree = tree_of<kD>(this->scattered(60, 1));
  divide(tree, tree.root(), 0, 25);
  EXPECT_FALSE(tree[tree[tree.root()].left].unsorted) << "the root's list is along axis 0 already";
  EXPECT_TRUE(is_sound(tree)) << "ordered without a sort";
  divide(tree, tree[tree.root()].left, 1, 25);
  EXPECT_TRUE(tree[tree[tree[tree.root()].left].left].unsorted) << "another normal, another order";
}

}  // namespace
}  // namespace kerf::test
