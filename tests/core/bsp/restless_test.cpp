// Most objects rest, some are too fast for any fat box: those are looked up in each step (DESIGN.md,
// "Speed").

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/bsp/bsp.h"
#include "core/bsp/bsp_state.h"
#include "core/replay/oracle.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/pairs.h"

namespace kerf::test {
namespace {

Config small_leaves() {
  Config config = tuned_config();
  config.min_threshold = 64;
  config.max_threshold = 64;
  return config;
}

/// A crowd at rest of which a few jump about, fall asleep and are relieved by others; objects shrink where
/// they are, come and go, are fixed and are not. All trees of `trees` get the same requests.
template <int D>
class Crowd {
 public:
  /// Object k has the id `stride` * k.
  Crowd(std::uint32_t count, std::vector<BroadPhase<D>*> trees, std::uint32_t awake = 40,
        std::uint32_t stride = 1)
      : trees_(std::move(trees)),
        side_(1.2 * std::pow(count, 1.0 / D)),
        stride_(stride),
        fixed_(count),
        awake_(awake, 0) {
    for (std::uint32_t id = 0; id < count; ++id) {
      boxes_.push_back(somewhere());
      fixed_[id] = id % 16 == 0;
      insert(id);
    }
    for (std::uint32_t& id : awake_) id = any();
  }
  void advance() {
    for (int k = 0; k < 3; ++k) {
      awake_[random_.below(static_cast<std::uint32_t>(awake_.size()))] = any();
      shrink(any());
    }
    for (const std::uint32_t id : awake_) jump(id, 0.5F);
    for (const std::uint32_t id : {awake_.front(), awake_.back(), any()}) replace(id);
  }
  /// All objects jump, not far.
  void shake(Scalar most) {
    for (std::uint32_t id = 0; id < boxes_.size(); ++id) jump(id, most);
  }
  /// All objects jump that lie in a corner with a share of each side: the low one, or the next ones.
  void shake_corner(int corner, double share, Scalar most) {
    const auto lies_there = [&](const Box<D>& box) {
      bool all = true;
      for (int i = 0; i < D; ++i) {
        const bool high = ((corner >> i) & 1) != 0;
        all &= high ? box.max[i] > (1 - share) * side_ : box.min[i] < share * side_;
      }
      return all;
    };
    for (std::uint32_t id = 0; id < boxes_.size(); ++id)
      if (lies_there(boxes_[id])) jump(id, most);
  }

 private:
  Box<D> somewhere() {
    const Vector<D> low = random_point<D>(random_, 0, side_);
    return {low, low + random_point<D>(random_, 0.5, 1.5)};
  }
  std::uint32_t any() { return random_.below(static_cast<std::uint32_t>(boxes_.size())); }
  void insert(std::uint32_t id) {
    for (BroadPhase<D>* tree : trees_)
      EXPECT_EQ(tree->insert({stride_ * id}, boxes_[id], fixed_[id] ? Mobility::fixed : Mobility::moving),
                Status::ok);
  }
  void move(std::uint32_t id, const Box<D>& box) {
    boxes_[id] = box;
    for (BroadPhase<D>* tree : trees_) EXPECT_EQ(tree->move({stride_ * id}, box), Status::ok);
  }
  void jump(std::uint32_t id, Scalar most) {
    const Vector<D> by = random_point<D>(random_, -most, most);
    move(id, {boxes_[id].min + by, boxes_[id].max + by});
  }
  void shrink(std::uint32_t id) {
    const Vector<D> by = (boxes_[id].max - boxes_[id].min) * 0.1F;
    move(id, {boxes_[id].min + by, boxes_[id].max - by});
  }
  /// In one step: it is another one, or the same one but fixed, or no longer so.
  void replace(std::uint32_t id) {
    for (BroadPhase<D>* tree : trees_) EXPECT_EQ(tree->remove({stride_ * id}), Status::ok);
    if (random_.below(2) == 0) {
      fixed_[id] = !fixed_[id];
    } else {
      boxes_[id] = somewhere();
    }
    insert(id);
  }

  std::vector<BroadPhase<D>*> trees_;
  double side_;
  std::uint32_t stride_;
  Random random_{77};
  std::vector<Box<D>> boxes_;
  std::vector<bool> fixed_;
  std::vector<std::uint32_t> awake_;
};

template <int D, class Trace>
std::uint32_t count_restless(const kerf::Bsp<D, Trace>& tree) {
  std::uint32_t count = 0;
  for (const Skin& skin : tree.state().skins) count += skin.is_restless() ? 1 : 0;
  return count;
}

template <int D, class Trace>
bool keeps(const kerf::Bsp<D, Trace>& tree) {
  return tree.mode() == Mode::kept;
}

template <class T>
class Restless : public testing::Test {};
TYPED_TEST_SUITE(Restless, Dimensions, DimensionNames);

TYPED_TEST(Restless, PairsAreTheOraclesWhateverWakesSleepsShrinksComesOrGoes) {
  constexpr int kD = TypeParam::value;
  kerf::Bsp<kD> tree(small_leaves());
  Crowd<kD> crowd(1200, {&tree});
  std::uint32_t most = 0;
  for (int step = 0; step < 120; ++step) {
    tree.step();
    EXPECT_TRUE(step == 0 || keeps(tree)) << step;
    most = std::max(most, count_restless(tree));
    ASSERT_EQ(difference(tree.pairs(), oracle_pairs(tree.objects())), "") << "step " << step;
    crowd.advance();
  }
  EXPECT_GT(most, 30U);
  EXPECT_LT(most, 150U) << "an object at rest is no longer restless";
}

/// So far apart are the ids that the boxes leave the caches: then candidates are named by places in their
/// leaf.
TYPED_TEST(Restless, PairsAreTheOraclesHoweverFarApartIdsAre) {
  constexpr int kD = TypeParam::value;
  constexpr std::uint32_t kStride = 401;
  kerf::Bsp<kD> tree(small_leaves());
  Crowd<kD> crowd(600, {&tree}, 20, kStride);
  for (int step = 0; step < 60; ++step) {
    tree.step();
    EXPECT_TRUE(step == 0 || keeps(tree)) << step;
    ASSERT_EQ(difference(tree.pairs(), oracle_pairs(tree.objects())), "") << "step " << step;
    crowd.advance();
    if (step % 3 == 0) crowd.shake(0.01F);
  }
}

/// In one corner of the crowd all fly, then those in another one: their leaves are swept, the others' pairs
/// kept.
TYPED_TEST(Restless, PairsAreTheOraclesWhereSomeLeavesAreSweptAndOthersKept) {
  constexpr int kD = TypeParam::value;
  kerf::Bsp<kD> tree(small_leaves());
  Crowd<kD> crowd(1500, {&tree}, 4);
  std::uint32_t most = 0;
  for (int step = 0; step < 150; ++step) {
    tree.step();
    EXPECT_TRUE(step == 0 || keeps(tree)) << step;
    most = std::max(most, count_restless(tree));
    ASSERT_EQ(difference(tree.pairs(), oracle_pairs(tree.objects())), "") << "step " << step;
    crowd.advance();
    crowd.shake(0.005F);
    if (step % 50 > 10) crowd.shake_corner(step / 50, kD == 2 ? 0.24 : 0.45, 0.3F);
  }
  EXPECT_GT(most, 100U);
}

TYPED_TEST(Restless, ACalmCrowdHasNone) {
  constexpr int kD = TypeParam::value;
  kerf::Bsp<kD> tree(small_leaves());
  Crowd<kD> crowd(1200, {&tree});
  for (int step = 0; step < 20; ++step, crowd.advance()) tree.step();
  EXPECT_GT(count_restless(tree), 0U);
  for (int step = 0; step < 2 * Skin::kRestless; ++step) tree.step();
  EXPECT_EQ(count_restless(tree), 0U);
  EXPECT_EQ(difference(tree.pairs(), oracle_pairs(tree.objects())), "");
}

/// The events of a step, as text.
template <int D>
std::vector<std::string> events_of(kerf::Bsp<D, EventLog>& tree) {
  std::vector<std::string> events;
  for (const Event& event : tree.trace().take()) events.push_back(describe(event, {}));
  return events;
}

/// So many are awake that threads share the work of placing them.
TYPED_TEST(Restless, ThreadsAndStatesGiveTheSameRun) {
  constexpr int kD = TypeParam::value;
  kerf::Bsp<kD, EventLog> alone(tuned_config());
  kerf::Bsp<kD, EventLog> shared(tuned_config());
  kerf::Bsp<kD, EventLog> restored(tuned_config());
  shared.set_threads(3, Sharing::always);
  Crowd<kD> crowd(20000, {&alone, &shared, &restored}, 1200);
  for (int step = 0; step < 24; ++step) {
    alone.step();
    shared.step();
    restored.step();
    EXPECT_TRUE(step == 0 || keeps(alone)) << "step " << step;
    ASSERT_TRUE(std::ranges::equal(alone.pairs(), shared.pairs())) << "step " << step;
    ASSERT_EQ(difference(restored.pairs(), alone.pairs()), "") << "step " << step;
    ASSERT_EQ(alone.state_hash(), shared.state_hash()) << "step " << step;
    ASSERT_EQ(alone.state_hash(), restored.state_hash()) << "step " << step;
    const std::vector<std::string> events = events_of(alone);
    ASSERT_EQ(events_of(shared), events) << "step " << step;
    ASSERT_EQ(events_of(restored), events) << "step " << step;
    if (step % 5 == 3) restored.restore(restored.state());
    crowd.advance();
  }
  EXPECT_GT(count_restless(alone), 1024U);
}

/// A recording may be damaged: what it does not say of the skins is learnt anew.
TYPED_TEST(Restless, AStateWithTooFewSkinsGoesOn) {
  constexpr int kD = TypeParam::value;
  kerf::Bsp<kD> recorded(small_leaves());
  kerf::Bsp<kD> fresh(small_leaves());
  Crowd<kD> crowd(1200, {&recorded, &fresh});
  for (int step = 0; step < 20; ++step) {
    crowd.advance();
    recorded.step();
  }
  ASSERT_TRUE(keeps(recorded));
  BspState<kD> state = recorded.state();
  state.skins.resize(10);
  fresh.restore(state);
  for (int step = 0; step < 20; ++step) {
    crowd.advance();
    fresh.step();
    ASSERT_EQ(difference(fresh.pairs(), oracle_pairs(fresh.objects())), "") << "step " << step;
  }
}

TYPED_TEST(Restless, StepsWithoutPairsChangeNothingElse) {
  constexpr int kD = TypeParam::value;
  kerf::Bsp<kD, EventLog> always(small_leaves());
  kerf::Bsp<kD, EventLog> seldom(small_leaves());
  Crowd<kD> crowd(1200, {&always, &seldom});
  for (int step = 0; step < 120; ++step) {
    const bool asked = step % 4 == 0;
    always.step();
    asked ? seldom.step() : seldom.step_unswept();
    EXPECT_TRUE(step == 0 || keeps(always)) << "step " << step;
    ASSERT_EQ(difference(seldom.pairs(), asked ? always.pairs() : std::span<const Pair>()), "")
        << "step " << step;
    ASSERT_EQ(seldom.state_hash(), always.state_hash()) << "step " << step;
    ASSERT_EQ(events_of(seldom), events_of(always)) << "step " << step;
    crowd.advance();
  }
}

TYPED_TEST(Restless, WhereManyAreTheLeavesAreSwept) {
  constexpr int kD = TypeParam::value;
  kerf::Bsp<kD> tree(small_leaves());
  Crowd<kD> crowd(800, {&tree});
  bool swept = false;
  for (int step = 0; step < 120; ++step) {
    if (step % 40 > 30) {
      crowd.shake(0.5);
    } else {
      crowd.advance();
    }
    tree.step();
    swept |= !keeps(tree);
    ASSERT_EQ(difference(tree.pairs(), oracle_pairs(tree.objects())), "") << "step " << step;
  }
  EXPECT_TRUE(swept);
}

/// How many objects have a fat box.
template <int D>
std::uint32_t count_fat(const kerf::Bsp<D>& tree) {
  std::uint32_t count = 0;
  for (std::uint32_t id = 0; id < tree.objects().bound(); ++id)
    count += tree.tree().table.packed({id}).lane == tree.objects().packed({id}).lane ? 0 : 1;
  return count;
}

/// Objects that were restless when all began to fly are not when all have come to rest.
TYPED_TEST(Restless, ACrowdThatLandsIsKeptSoon) {
  constexpr int kD = TypeParam::value;
  kerf::Bsp<kD> tree(small_leaves());
  Crowd<kD> crowd(1200, {&tree});
  for (int step = 0; step < 60; ++step, crowd.advance()) tree.step();
  for (int step = 0; step < 30; ++step, crowd.shake(0.5)) tree.step();
  ASSERT_FALSE(keeps(tree));
  for (int step = 0; step < 14; ++step) {
    tree.step();
    ASSERT_EQ(difference(tree.pairs(), oracle_pairs(tree.objects())), "") << "step " << step;
    if (!keeps(tree)) continue;
    EXPECT_EQ(count_restless(tree), 0U) << "step " << step;
  }
  EXPECT_TRUE(keeps(tree));
}

TYPED_TEST(Restless, WhatLiesStillLosesItsFat) {
  constexpr int kD = TypeParam::value;
  kerf::Bsp<kD> tree(small_leaves());
  Crowd<kD> crowd(1200, {&tree}, 2);
  for (int step = 0; step < 40; ++step, crowd.shake(0.005F)) tree.step();
  EXPECT_GT(count_fat(tree), 1000U);
  for (std::uint32_t step = 0; step < 2 * tuning::kLookSteps + 1; ++step) {
    tree.step();
    ASSERT_EQ(difference(tree.pairs(), oracle_pairs(tree.objects())), "") << "step " << step;
    EXPECT_TRUE(keeps(tree)) << step;
  }
  EXPECT_EQ(count_fat(tree), 0U);
  for (int step = 0; step < 200; ++step) {
    crowd.shake(0.001F);
    tree.step();
  }
  EXPECT_GT(count_fat(tree), 1100U) << "an object that moves, however little, has fat";
  EXPECT_EQ(difference(tree.pairs(), oracle_pairs(tree.objects())), "");
}

}  // namespace
}  // namespace kerf::test
