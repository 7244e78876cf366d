#include "core/tree/balance.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/tree/criteria.h"
#include "core/tree/hash.h"
#include "tests/support/boxes.h"
#include "tests/support/config_of.h"
#include "tests/support/dimensions.h"
#include "tests/support/pairs.h"
#include "tests/support/planted_tree.h"
#include "tests/support/sound.h"

namespace kerf::test {
namespace {

template <class T>
class Balance : public testing::Test {
 protected:
  static constexpr int kSize = T::value;

  /// Unit slabs at 0, 2, 4, ... along axis 0.
  static std::vector<Box<kSize>> row(int count) {
    std::vector<Box<kSize>> boxes;
    for (int k = 0; k < count; ++k)
      boxes.push_back(slab<kSize>(static_cast<Scalar>(2 * k), static_cast<Scalar>(2 * k + 1)));
    return boxes;
  }
};
TYPED_TEST_SUITE(Balance, Dimensions, DimensionNames);

TYPED_TEST(Balance, KeepsEveryObjectAtEveryNodeOfRandomTrees) {
  Random random(1);
  int acted = 0;
  for (int round = 0; round < 30; ++round) {
    auto original = random_tree<TypeParam::value>(random, 40, round % 2 == 0 ? 0.5 : 4, 12, 8);
    for (const NodeId inner : inner_nodes(original)) {
      auto tree = original;
      const auto objects = objects_below(tree, inner);
      Refusal refusal{};
      const Config config = config_of("max_redundancy=0.4,min_balance=0.3");
      const auto event = balance(tree, inner, config, refusal);
      if (!event) {
        ASSERT_EQ(refusal, Refusal::no_partitioner);
        ASSERT_EQ(hash(tree), hash(original)) << "a refusal leaves no trace";
        continue;
      }
      ++acted;
      sort_phase(tree);
      ASSERT_TRUE(is_sound(tree));
      ASSERT_EQ(objects_below(tree, inner), objects);
      ASSERT_TRUE(is_good(event->after, config));
      ASSERT_EQ(event->after, quality(tree, inner));
      ASSERT_TRUE(same_pairs(swept(tree), overlapping(tree)));
    }
  }
  EXPECT_GT(acted, 30);
}

TYPED_TEST(Balance, ShiftsToTheBestPointAndReportsIt) {
  constexpr int kD = TypeParam::value;
  auto tree = tree_of<kD>(this->row(10));
  plant(tree, tree.root(), 0, 1.5F);
  Refusal refusal{};
  const auto event = balance(tree, tree.root(), Config{}, refusal);
  ASSERT_TRUE(event);
  EXPECT_EQ(event->op, Operator::balance);
  EXPECT_EQ(event->node, tree.ref(tree.root()));
  EXPECT_EQ(event->before, (Quality{10, 1, 9}));
  EXPECT_EQ(event->after, (Quality{10, 5, 5}));
  EXPECT_EQ(event->direction, 0U);
  EXPECT_EQ(event->old_offset, 1.5F);
  EXPECT_EQ(event->new_offset, 9.5F);
  EXPECT_EQ(tree[tree.root()].plane.offset, 9.5F);
  sort_phase(tree);
  EXPECT_TRUE(is_sound(tree));
}

TYPED_TEST(Balance, RefusesWhenNoShiftIsGood) {
  constexpr int kD = TypeParam::value;
  auto tree = tree_of<kD>(std::vector(10, slab<kD>(0, 1)));
  plant(tree, tree.root(), 0, 5);
  const std::uint64_t before = hash(tree);
  Refusal refusal{};
  EXPECT_FALSE(balance(tree, tree.root(), Config{}, refusal));
  EXPECT_EQ(refusal, Refusal::no_partitioner);
  EXPECT_EQ(hash(tree), before);
}

TYPED_TEST(Balance, ForgetsStraddlersOfTheOldOffset) {
  constexpr int kD = TypeParam::value;
  std::vector<Box<kD>> boxes = this->row(10);
  boxes.push_back(slab<kD>(0.5F, 2.5F));
  auto tree = tree_of<kD>(boxes);
  plant(tree, tree.root(), 0, 1.5F);
  ASSERT_EQ(tree.entries(), 12U);
  Refusal refusal{};
  ASSERT_TRUE(balance(tree, tree.root(), Config{}, refusal));
  EXPECT_EQ(tree.entries(), 11U);
  sort_phase(tree);
  EXPECT_TRUE(is_sound(tree));
}

TYPED_TEST(Balance, MarksStraddlersOfTheNewOffset) {
  constexpr int kD = TypeParam::value;
  std::vector<Box<kD>> boxes = this->row(10);
  boxes.push_back(slab<kD>(8.5F, 10.5F));
  auto tree = tree_of<kD>(boxes);
  plant(tree, tree.root(), 0, 1.5F);
  Refusal refusal{};
  const auto event = balance(tree, tree.root(), config_of("max_redundancy=0.1,min_balance=0.9"), refusal);
  ASSERT_TRUE(event);
  EXPECT_EQ(redundancy(event->after), 1U);
  sort_phase(tree);
  EXPECT_TRUE(is_sound(tree));
  EXPECT_TRUE(same_pairs(swept(tree), overlapping(tree)));
}

/// HARD_CASES O1. The best gap of these objects is one ulp wide, so that the new offset lies exactly on ends
/// of objects, as the old one does.
template <int D>
void expect_sound_shift(const std::vector<Box<D>>& boxes, Scalar old_offset, Scalar new_offset) {
  auto tree = tree_of<D>(boxes);
  plant(tree, tree.root(), 1, 0.5F);  // parts nothing: masks above the shifted plane are not empty
  const NodeId inner = tree[tree.root()].left;
  plant(tree, inner, 0, old_offset);
  plant(tree, tree[inner].left, 1, 0.7F);
  plant(tree, tree[inner].right, 0, 15);
  ASSERT_TRUE(is_sound(tree));
  Refusal refusal{};
  const auto event = balance(tree, inner, Config{}, refusal);
  ASSERT_TRUE(event);
  ASSERT_EQ(event->new_offset, new_offset);
  sort_phase(tree);
  EXPECT_TRUE(is_sound(tree));
  EXPECT_TRUE(same_pairs(swept(tree), overlapping(tree)));
}

TYPED_TEST(Balance, TakesObjectsThatEndExactlyAtTheOldOrTheNewOffset) {
  constexpr int kD = TypeParam::value;
  const Scalar above2 = std::nextafter(2.0F, 3.0F);
  const Scalar below2 = std::nextafter(2.0F, 1.0F);
  const Scalar above10 = std::nextafter(10.0F, 11.0F);
  const Scalar below10 = std::nextafter(10.0F, 9.0F);
  const std::vector<Box<kD>> rising{slab<kD>(0, 2),
                                    slab<kD>(2, 2),
                                    slab<kD>(2, 10),
                                    slab<kD>(above2, 10),
                                    slab<kD>(0, below2),
                                    slab<kD>(0, 10),
                                    slab<kD>(10, 10),
                                    slab<kD>(below2, below10),
                                    slab<kD>(above10, 20),
                                    slab<kD>(above10, 14),
                                    slab<kD>(above10, above10),
                                    slab<kD>(11, 12),
                                    slab<kD>(12, 20),
                                    slab<kD>(above10, 11),
                                    slab<kD>(15, 16),
                                    slab<kD>(16, 17)};
  expect_sound_shift(rising, 2, 10);
  const std::vector<Box<kD>> falling{
      slab<kD>(0, 2),   slab<kD>(2, 2),      slab<kD>(0, below2),  slab<kD>(0, 0),
      slab<kD>(1, 2),   slab<kD>(below2, 2), slab<kD>(above2, 10), slab<kD>(above2, below10),
      slab<kD>(10, 10), slab<kD>(10, 20),    slab<kD>(above2, 20), slab<kD>(below10, above10)};
  expect_sound_shift(falling, 10, 2);
}

TYPED_TEST(Balance, WorksWithTheWholeRangeOfFloats) {
  constexpr int kD = TypeParam::value;
  constexpr Scalar kMax = std::numeric_limits<Scalar>::max();
  auto tree = tree_of<kD>(
      std::vector{slab<kD>(-kMax, -kMax), slab<kD>(-kMax, -1), slab<kD>(1, kMax), slab<kD>(kMax, kMax)});
  plant(tree, tree.root(), 0, -kMax);
  Refusal refusal{};
  const auto event = balance(tree, tree.root(), Config{}, refusal);
  ASSERT_TRUE(event);
  EXPECT_EQ(event->after, (Quality{4, 2, 2}));
  sort_phase(tree);
  EXPECT_TRUE(is_sound(tree));
}

}  // namespace
}  // namespace kerf::test
