// What the S and M cases promise beside the pairs: that time, memory and the number of events stay bounded.

#include <gtest/gtest.h>

#include <string>

#include "core/bsp/bsp.h"
#include "tests/hard/cases.h"
#include "tests/hard/settings.h"
#include "tests/hard/trial.h"
#include "tests/support/boxes.h"
#include "tests/support/config_of.h"
#include "tests/support/dimensions.h"

namespace kerf::test {
namespace {

template <class T>
class HardBounds : public testing::Test {
 protected:
  static constexpr int kSize = T::value;

  static Trial trial_of(std::string_view id, std::string_view config) {
    for (const HardCase& hard_case : hard_cases()) {
      if (hard_case.id != id) continue;
      const Script<kSize> script = make_script<kSize>(hard_case, Size::test);
      Setting setting;
      setting.config = config;
      Trial trial;
      play_kerf(script, find_truth(script, VolumeKind::box, Feed::boxes), setting, trial);
      EXPECT_TRUE(trial.is_exact()) << trial.note.data();
      return trial;
    }
    ADD_FAILURE() << "no case " << id;
    return {};
  }
};
TYPED_TEST_SUITE(HardBounds, Dimensions, DimensionNames);

TYPED_TEST(HardBounds, S1_SplitsOfAHeapAreRefusedAndBackOff) {
  constexpr int kD = TypeParam::value;
  Bsp<kD> bsp(config_of("schedule_interval=1,budget_divisor=1"));
  for (std::uint32_t k = 0; k < 100; ++k)
    EXPECT_EQ(bsp.insert({k}, {all<kD>(0), all<kD>(1)}, Mobility::moving), Status::ok);
  for (int step = 0; step < 320; ++step) bsp.step();
  const Statistics s = bsp.statistics();
  EXPECT_EQ(s.leaves, 1U);
  EXPECT_EQ(bsp.pairs().size(), 100U * 99U / 2U);
  // After 1, 2, 4, 8 and 16 steps, then every 16: 320 / 16 + 4 times, and one for the first.
  EXPECT_GE(s.refused, 10U);
  EXPECT_LE(s.refused, 25U);
}

TYPED_TEST(HardBounds, S2_GrowingBoxesAreShedFromTheTreeInTheSameStep) {
  constexpr int kD = TypeParam::value;
  Bsp<kD> bsp(config_of(kEagerConfig));
  Random random(2);
  for (std::uint32_t k = 0; k < 300; ++k)
    EXPECT_EQ(bsp.insert({k}, random_box<kD>(random, 100, 1), Mobility::moving), Status::ok);
  for (int step = 0; step < 40; ++step) bsp.step();
  ASSERT_GT(bsp.statistics().leaves, 30U);
  const std::uint64_t merges = bsp.statistics().count(Operator::merge);
  for (std::uint32_t k = 0; k < 300; ++k) EXPECT_EQ(bsp.move({k}, {all<kD>(-1), all<kD>(101)}), Status::ok);
  bsp.step();
  EXPECT_EQ(bsp.statistics().entries, 300U) << "every partitioner parts nothing now";
  EXPECT_EQ(bsp.statistics().count(Operator::merge), merges + 1) << "at the root";
  EXPECT_EQ(bsp.pairs().size(), 300U * 299U / 2U);
}

TYPED_TEST(HardBounds, S2_WhatIsNotStraddledIsKeptWhenEntriesAreShed) {
  constexpr int kD = TypeParam::value;
  Bsp<kD> bsp(config_of(std::string(kEagerConfig) + ",max_entries=1.5"));
  Random random(3);
  for (std::uint32_t k = 0; k < 400; ++k) {
    Box<kD> box = random_box<kD>(random, 50, 0.3);
    const Scalar aside = k % 2 == 0 ? 0.0F : 1000.0F;
    box.min[0] += aside;
    box.max[0] += aside;
    EXPECT_EQ(bsp.insert({k}, box, Mobility::moving), Status::ok);
  }
  for (int step = 0; step < 60; ++step) bsp.step();
  const std::uint32_t leaves = bsp.statistics().leaves;
  for (std::uint32_t k = 0; k < 400; k += 2) EXPECT_EQ(bsp.move({k}, {all<kD>(0), all<kD>(50)}), Status::ok);
  bsp.step();
  const Statistics s = bsp.statistics();
  EXPECT_LE(s.entries, 600U);
  EXPECT_GT(s.leaves, leaves / 3) << "the quiet half has its partitioners still";
  EXPECT_LT(s.leaves, leaves);
}

TYPED_TEST(HardBounds, S3_StraddledPlanesAreRefused) {
  const Trial trial = this->trial_of("S3", "");
  EXPECT_LE(trial.entries, 1.2) << "the paper's 2.5 % for each plane";
}

TYPED_TEST(HardBounds, S7_HeightIsCapped) {
  const Trial free = this->trial_of("S7",
                                    "min_threshold=2,max_threshold=4,schedule_interval=1,budget_divisor=1,"
                                    "max_redundancy=0.4,min_balance=0.01");
  EXPECT_LE(free.height, 40U);
  const Trial low = this->trial_of("S7",
                                   "min_threshold=2,max_threshold=4,schedule_interval=1,budget_divisor=1,"
                                   "max_redundancy=0.4,min_balance=0.01,max_height=5");
  EXPECT_EQ(low.height, 5U);
}

TYPED_TEST(HardBounds, S8_NumbersOfObjectsMayBeFarApart) {
  constexpr int kD = TypeParam::value;
  Bsp<kD> bsp;
  for (const std::uint32_t id : {0U, 65535U, 65536U, 70000U, 1000000U})
    EXPECT_EQ(bsp.insert({id}, {all<kD>(0), all<kD>(1)}, Mobility::moving), Status::ok);
  EXPECT_EQ(bsp.insert(ObjectId::none(), {all<kD>(0), all<kD>(1)}, Mobility::moving), Status::unknown_id);
  bsp.step();
  EXPECT_EQ(bsp.pairs().size(), 10U);
}

TYPED_TEST(HardBounds, V10_ALargeGroundCostsNoMoreThanTheCap) {
  const Trial trial = this->trial_of("V10", kEagerConfig);
  EXPECT_LE(trial.entries, 2 * 4.0 + 1);
}

/// Algorithm 1 with the paper's numbers: at most ceil(64 / 16) = 4 listed events a step, beside the shifts
/// that it does at once, one for each node on a cut through the tree.
TYPED_TEST(HardBounds, M8_OscillationCausesFewEvents) {
  const Trial trial = this->trial_of("M8", "");
  std::uint64_t acted = 0;
  for (const std::uint64_t count : trial.operators) acted += count;
  EXPECT_LE(trial.most_operators, 8U);
  EXPECT_LE(acted, 40U) << "over " << trial.steps << " steps";
}

TYPED_TEST(HardBounds, M9_CollapseAndExplosionAreWorkedOffInPortions) {
  const Trial trial = this->trial_of("M9", "");
  EXPECT_LE(trial.most_operators, 8U);
}

}  // namespace
}  // namespace kerf::test
