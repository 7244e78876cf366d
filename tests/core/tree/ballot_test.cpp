#include "core/tree/ballot.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/boxes.h"
#include "tests/support/config_of.h"
#include "tests/support/dimensions.h"

namespace kerf {
namespace {

template <class T>
class BallotTest : public testing::Test {};
TYPED_TEST_SUITE(BallotTest, test::Dimensions, test::DimensionNames);

/// A leaf with these boxes.
template <int D>
Tree<D> tree_of(const std::vector<Box<D>>& boxes, const Config& config) {
  Tree<D> tree(make_projector<D>(config, VolumeKind::box));
  for (std::uint32_t id = 0; id < boxes.size(); ++id) {
    (void)tree.table.insert(ObjectId{id}, boxes[id], Mobility::moving);
    place(tree, tree.root(), ObjectId{id}, 0);
  }
  return tree;
}

template <int D>
BallotEntry entry_of(const std::vector<BallotEntry>& entries, std::uint32_t direction) {
  return *std::ranges::find(entries, direction, &BallotEntry::direction);
}

/// Eight boxes in a row along axis 0; along the others they coincide.
TYPED_TEST(BallotTest, SaysWhyEachCandidateWonOrLost) {
  constexpr int kD = TypeParam::value;
  const Config config = test::config_of("free_directions=0");
  std::vector<Box<kD>> boxes;
  for (int k = 0; k < 8; ++k)
    boxes.push_back(test::slab<kD>(static_cast<Scalar>(3 * k), static_cast<Scalar>(3 * k + 1)));
  const Tree<kD> tree = tree_of<kD>(boxes, config);
  const auto entries = ballot(tree, Operator::split, tree.root(), config);
  ASSERT_EQ(entries.size(), static_cast<std::size_t>(kD));
  EXPECT_EQ(entries.front().direction, 0U);
  EXPECT_EQ(entries.front().result, Ballot::chosen);
  EXPECT_EQ(entries.front().quality, (Quality{8, 4, 4}));
  EXPECT_EQ(entry_of<kD>(entries, 1).result, Ballot::undividing);
}

TYPED_TEST(BallotTest, UnbalancedAndRedundantPointsAreReported) {
  constexpr int kD = TypeParam::value;
  const Config config = test::config_of("free_directions=0");
  std::vector<Box<kD>> boxes;
  for (int k = 0; k < 9; ++k) {  // axis 0: one apart from eight; axis 1: a chain in which each cut meets some
    Box<kD> box = test::slab<kD>(k == 0 ? 0.0F : 5.0F, k == 0 ? 1.0F : 6.0F);
    box.min[1] = static_cast<Scalar>(k);
    box.max[1] = static_cast<Scalar>(k) + 2.5F;
    boxes.push_back(box);
  }
  const Tree<kD> tree = tree_of<kD>(boxes, config);
  const auto entries = ballot(tree, Operator::split, tree.root(), config);
  EXPECT_EQ(entry_of<kD>(entries, 0).result, Ballot::unbalanced);
  EXPECT_EQ(entry_of<kD>(entries, 1).result, Ballot::redundant);
  EXPECT_EQ(std::ranges::count(entries, Ballot::chosen, &BallotEntry::result), 0);
}

TYPED_TEST(BallotTest, HoldsTheOperatorsChoiceAlsoWhenItSamples) {
  constexpr int kD = TypeParam::value;
  Random random(1);
  for (const char* const sample : {"sample=256", "sample=12"}) {
    const Config config = test::config_of(sample);
    for (int round = 0; round < 20; ++round) {
      std::vector<Box<kD>> boxes;
      for (int k = 0; k < 80; ++k) boxes.push_back(test::random_box<kD>(random, 40, 0.5));
      const Tree<kD> tree = tree_of<kD>(boxes, config);
      const auto entries = ballot(tree, Operator::split, tree.root(), config);
      EXPECT_EQ(entries.size(), directions_tried(tree, tree.root(), config));
      const auto chosen = choose_partitioner(tree, tree.root(), config);
      EXPECT_EQ(entries.front().result == Ballot::chosen, chosen.has_value());
      if (!chosen) continue;
      EXPECT_EQ(entries.front().direction, chosen->direction);
      EXPECT_EQ(entries.front().offset, chosen->offset);
      for (std::size_t i = 2; i < entries.size(); ++i) {
        const bool good = is_good(entries[i].quality, config);
        EXPECT_GE(is_good(entries[i - 1].quality, config), good);
        if (is_good(entries[i - 1].quality, config) == good) {
          EXPECT_GE(score(entries[i - 1].quality), score(entries[i].quality));
        }
      }
    }
  }
}

TYPED_TEST(BallotTest, MergesAndSwapsChooseNothing) {
  constexpr int kD = TypeParam::value;
  const Tree<kD> tree = tree_of<kD>({test::slab<kD>(0, 1)}, {});
  EXPECT_TRUE(ballot(tree, Operator::merge, tree.root(), {}).empty());
  EXPECT_TRUE(ballot(tree, Operator::swap, tree.root(), {}).empty());
}

}  // namespace
}  // namespace kerf
