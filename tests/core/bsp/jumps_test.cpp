// What comes after steps in which everything jumped: other requests, earlier states, kept pairs.
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "core/bsp/bsp.h"
#include "core/bsp/bsp_state.h"
#include "core/replay/oracle.h"
#include "tests/support/boxes.h"
#include "tests/support/config_of.h"
#include "tests/support/dimensions.h"
#include "tests/support/pairs.h"

namespace kerf::test {
namespace {

/// Leaves are swept in each step, never kept.
Config swept() {
  Config config = tuned_with_leaves_of(32);
  config.skin = 0;
  return config;
}

/// Some hundred objects of which all jumped in the last two steps.
template <int D>
class JumpingTest : public testing::Test {
 protected:
  static constexpr std::uint32_t kCount = 300;

  JumpingTest() {
    for (std::uint32_t id = 0; id < kCount; ++id) {
      truth_.push_back(somewhere());
      EXPECT_EQ(tree_.insert({id}, truth_.back(), id % 8 == 0 ? Mobility::fixed : Mobility::moving),
                Status::ok);
    }
    tree_.step();
    jump(0, kCount);
    tree_.step();
    jump(0, kCount);
    tree_.step();
  }
  Box<D> somewhere() { return random_box<D>(random_, 10, 0.6); }
  void jump(std::uint32_t first, std::uint32_t end) {
    std::vector<ObjectId> ids;
    for (std::uint32_t id = first; id < end; ++id) {
      truth_[id] = somewhere();
      ids.push_back({id});
    }
    (void)tree_.move_many(ids, std::span(truth_).subspan(first, end - first));
  }
  /// All move, none of them far.
  void drift() {
    std::vector<ObjectId> ids;
    for (std::uint32_t id = 0; id < kCount; ++id) {
      const Vector<D> way = random_point<D>(random_, -0.001, 0.001);
      truth_[id] = {truth_[id].min + way, truth_[id].max + way};
      ids.push_back({id});
    }
    EXPECT_EQ(tree_.move_many(ids, truth_), Status::ok);
  }
  void expect_truth() {
    for (std::uint32_t id = 0; id < truth_.size(); ++id)
      if (tree_.objects().is_placed({id})) {
        ASSERT_EQ(tree_.objects().box({id}), truth_[id]) << id;
      }
  }
  void step_and_expect_truth() {
    tree_.step();
    expect_truth();
    EXPECT_TRUE(same_pairs(tree_.pairs(), oracle_pairs(tree_.objects())));
  }

  Random random_{7};
  Bsp<D> tree_{swept()};
  std::vector<Box<D>> truth_;
};

template <class Dim>
class Jumps : public JumpingTest<Dim::value> {};
TYPED_TEST_SUITE(Jumps, Dimensions, DimensionNames);

TYPED_TEST(Jumps, WhatDoesNotMoveAgainStaysWhereItIs) {
  for (const std::uint32_t first : {1U, 100U, 299U, 0U}) {
    this->jump(first, TestFixture::kCount);
    this->expect_truth();
    this->step_and_expect_truth();
  }
}

TYPED_TEST(Jumps, OneComesAndOneGoes) {
  this->truth_.push_back(this->somewhere());
  EXPECT_EQ(this->tree_.insert({TestFixture::kCount}, this->truth_.back(), Mobility::moving), Status::ok);
  this->expect_truth();
  this->step_and_expect_truth();
  this->jump(0, TestFixture::kCount);
  this->step_and_expect_truth();
  EXPECT_EQ(this->tree_.remove({5}), Status::ok);
  this->expect_truth();
  this->step_and_expect_truth();
}

TYPED_TEST(Jumps, OneOfThemCannotBePlaced) {
  std::vector<ObjectId> ids;
  for (std::uint32_t id = 0; id < TestFixture::kCount; ++id) ids.push_back({id});
  this->truth_[9].max[0] = std::numeric_limits<Scalar>::quiet_NaN();
  EXPECT_EQ(this->tree_.move_many(ids, this->truth_), Status::quarantined);
  this->step_and_expect_truth();
  this->jump(0, TestFixture::kCount);
  this->step_and_expect_truth();
}

TYPED_TEST(Jumps, AnotherTreeGoesOnFromThere) {
  const auto state = this->tree_.state();
  const auto boxes = this->truth_;
  this->jump(50, 250);
  this->step_and_expect_truth();
  const std::vector<Pair> pairs(this->tree_.pairs().begin(), this->tree_.pairs().end());
  const auto moved = this->truth_;

  Bsp<TypeParam::value> other(swept());
  other.restore(state);
  for (std::uint32_t id = 0; id < boxes.size(); ++id) ASSERT_EQ(other.objects().box({id}), boxes[id]) << id;
  for (std::uint32_t id = 50; id < 250; ++id) EXPECT_EQ(other.move({id}, moved[id]), Status::ok);
  other.step();
  EXPECT_TRUE(same_pairs(other.pairs(), pairs));
  EXPECT_EQ(other.state_hash(), this->tree_.state_hash());
}

TYPED_TEST(Jumps, AnEarlierStateComesBack) {
  const auto state = this->tree_.state();
  const auto boxes = this->truth_;
  this->jump(0, TestFixture::kCount);
  this->tree_.step();
  this->tree_.restore(state);
  this->truth_ = boxes;
  this->expect_truth();
  this->step_and_expect_truth();
}

/// Pairs are kept from the first step on in which few are fast.
Config keeping() {
  Config config = swept();
  config.skin = tuned_config().skin;
  return config;
}

TYPED_TEST(Jumps, KeepingPairsBeginsWithTheLatestBoxes) {
  this->tree_.set_config(keeping());
  for (std::uint32_t id = 0; id < 40; ++id) {
    this->truth_[id] = this->somewhere();
    EXPECT_EQ(this->tree_.move({id}, this->truth_[id]), Status::ok);
    this->step_and_expect_truth();
  }
}

TYPED_TEST(Jumps, KeepingPairsBeginsInAQuietStep) {
  for (int step = 0; step < 3; ++step) {
    this->drift();
    this->step_and_expect_truth();
  }
  this->tree_.set_config(keeping());
  for (int step = 0; step < 40; ++step) this->step_and_expect_truth();
}

TYPED_TEST(Jumps, WhereKeepingWasForbiddenItDoesNotBeginAmongWhatJumps) {
  this->tree_.set_config(keeping());
  for (int step = 0; step < 40; ++step) this->step_and_expect_truth();
  ASSERT_TRUE(this->tree_.mode() == Mode::kept);
  this->tree_.set_config(swept());
  this->step_and_expect_truth();
  this->tree_.set_config(keeping());
  for (int step = 0; step < 3; ++step) {
    this->jump(0, TestFixture::kCount);
    this->step_and_expect_truth();
    EXPECT_FALSE(this->tree_.mode() == Mode::kept);
  }
}

TYPED_TEST(Jumps, AStateWithKeptPairsComesBack) {
  this->tree_.set_config(keeping());
  for (int step = 0; step < 40; ++step) {
    this->drift();
    this->step_and_expect_truth();
  }
  const auto state = this->tree_.state();
  const auto boxes = this->truth_;
  this->tree_.set_config(swept());
  for (int step = 0; step < 3; ++step) {
    this->drift();
    this->step_and_expect_truth();
  }
  this->tree_.restore(state);
  this->truth_ = boxes;
  this->expect_truth();
  this->step_and_expect_truth();
}

}  // namespace
}  // namespace kerf::test
