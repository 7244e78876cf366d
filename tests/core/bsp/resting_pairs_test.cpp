// What rests keeps its place among the pairs of a step, whatever comes and goes around it.

#include "core/bsp/resting_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/bsp/bsp.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/pairs.h"
#include "tests/support/planted_tree.h"

namespace kerf::test {
namespace {

/// The leaves of a tree, each with pairs of objects that only it has.
template <class T>
class Resting : public testing::Test {
 protected:
  static constexpr int kD = T::value;
  static constexpr std::uint32_t kObjects = 40;  ///< of a leaf

  Resting() : tree_(tree_of<kD>(std::vector<Box<kD>>{box_at<kD>({}, 1)})) {
    plant_at_random(tree_, 6, 6, random_);
    leaves_.make_room(tree_);
    std::vector<NodeId> ids;
    list_leaves(tree_, ids);
    for (const NodeId id : ids) give_life(id.index());
  }

  static NodeId node(std::size_t k) { return {static_cast<std::uint32_t>(k)}; }
  void give_life(std::size_t k) {
    LeafView<kD> view;
    view.boxes.resize(kObjects);
    view.apart.resize(kObjects);
    for (std::uint32_t i = 0; i < kObjects; ++i)
      view.objects.push_back({static_cast<std::uint32_t>(k) * kObjects + i});
    empty_leaf(view, leaves_[node(k)]);
    append_entries(view, leaves_[node(k)]);
    leaves_.renew(tree_, node(k));
  }
  [[nodiscard]] std::uint32_t any_object(std::size_t k) {
    return static_cast<std::uint32_t>(k) * kObjects + random_.below(kObjects);
  }
  void add(std::size_t k, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t a = any_object(k);
      const std::uint32_t b = any_object(k);
      const Pair pair = make_pair({a}, {b});
      const auto& has = leaves_[node(k)].resting.pairs;
      if (a != b && std::ranges::find(has, pair) == has.end()) leaves_[node(k)].resting.push_back(pair);
    }
  }
  /// What happens to one leaf in one step.
  void change(std::size_t k) {
    switch (random_.below(8)) {
      case 0:
        drop_objects<kD>(leaves_[node(k)], std::array{any_object(k)});
        break;
      case 1: {
        std::vector<std::uint8_t> marks(leaves_.size() * kObjects, 0);
        for (int i = 0; i < 20; ++i) marks[any_object(k)] = 1;
        drop_marked<kD>(leaves_[node(k)], marks);
        break;
      }
      case 2:
        ++tree_[node(k)].generation;  // what is kept is of no node
        break;
      case 3:
        give_life(k);
        [[fallthrough]];
      default:
        add(k, random_.below(4));
    }
  }
  /// One step, with so many other pairs. The leaves change between its begin and its end.
  void step(std::uint32_t others, bool quiet = false) {
    resting_.begin_step(tree_, leaves_, pairs_);
    std::vector<Pair> expected;
    for (std::size_t k = 0; k < leaves_.size(); ++k) {
      const NodeId id = node(k);
      if (!tree_[id].is_leaf()) continue;
      if (!quiet) change(k);
      if (!leaves_.has(tree_, id)) continue;
      const RestingList& list = leaves_[node(k)].resting;
      expected.insert(expected.end(), list.pairs.begin(), list.pairs.end());
      pairs_.append(list.others());
    }
    for (std::uint32_t i = 0; i < others; ++i) {
      const Pair pair{{1000000 + i}, {2000000}};
      pairs_.push_back(pair);
      expected.push_back(pair);
    }
    resting_.end_step(tree_, leaves_, pairs_);
    ASSERT_TRUE(same_pairs(pairs_.all(), expected));
  }
  [[nodiscard]] std::vector<Pair> pairs() const { return {pairs_.all().begin(), pairs_.all().end()}; }

  Random random_{4};
  kerf::Tree<kD> tree_;
  KeptLeaves<kD> leaves_;
  RestingPairs<kD> resting_;
  PairBuffer pairs_;
};
TYPED_TEST_SUITE(Resting, Dimensions, DimensionNames);

TYPED_TEST(Resting, PairsAreAllReportedOnceWhateverLeavesLoseAndGet) {
  for (int k = 0; k < 2000; ++k) {
    const bool many_others = this->random_.below(2) == 0;
    this->step(many_others ? 60 : this->random_.below(3));
    ASSERT_FALSE(this->HasFatalFailure()) << "step " << k;
  }
}

TYPED_TEST(Resting, PairsAreLaidOutAnewWithoutThoseOfTheLastStep) {
  for (int k = 0; k < 20; ++k) {
    this->step(5);
    this->pairs_.clear();
  }
  this->step(0, true);
}

TYPED_TEST(Resting, PairsGetAPlaceOnceTheyAreManyAndKeepIt) {
  for (std::size_t k = 0; k < this->leaves_.size(); ++k)
    if (this->tree_[{static_cast<std::uint32_t>(k)}].is_leaf()) this->add(k, 30);
  this->step(7, true);
  this->step(7, true);
  for (std::size_t k = 0; k < this->leaves_.size(); ++k)
    EXPECT_TRUE(this->leaves_[this->node(k)].resting.others().empty()) << k;
  const std::vector<Pair> before = this->pairs();
  this->step(7, true);
  EXPECT_EQ(this->pairs(), before);
}

/// A crowd at rest in which one object jumps: nearly all pairs stay where they are.
TYPED_TEST(Resting, PairsOfACrowdAtRestStayWhereTheyAre) {
  constexpr int kDimension = TypeParam::value;
  constexpr std::uint32_t kCount = 4000;
  Random random(6);
  const double side = std::pow(kCount / 2.0, 1.0 / kDimension);
  Bsp<kDimension> tree(tuned_config());
  std::vector<Box<kDimension>> boxes;
  for (std::uint32_t id = 0; id < kCount; ++id) {
    boxes.push_back(random_box<kDimension>(random, side, 0.5));
    ASSERT_EQ(tree.insert({id}, boxes.back(), Mobility::moving), Status::ok);
  }
  std::vector<Pair> before;
  std::size_t moved = 0;
  for (int step = 0; step < 60; ++step) {
    const std::uint32_t id = random.below(kCount);
    ASSERT_EQ(tree.move({id}, random_box<kDimension>(random, side, 0.5)), Status::ok);
    tree.step();
    if (step >= 50)
      for (std::size_t k = 0; k < std::min(before.size(), tree.pairs().size()); ++k)
        moved += before[k] == tree.pairs()[k] ? 0 : 1;
    before.assign(tree.pairs().begin(), tree.pairs().end());
  }
  EXPECT_GT(before.size(), kCount / 2);
  EXPECT_LT(moved, before.size() / 2) << "in ten steps";
}

}  // namespace
}  // namespace kerf::test
