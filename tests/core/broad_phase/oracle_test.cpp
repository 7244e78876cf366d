// The promise of the whole: on moving scenes, in both dimensions and with every configuration, each step's
// pairs are the oracle's, each once, and the tree stays sound.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "core/bsp/bsp.h"
#include "tests/support/checked.h"
#include "tests/support/config_of.h"
#include "tests/support/dimensions.h"
#include "tests/support/moving_boxes.h"
#include "tests/support/sound.h"

namespace kerf::test {
namespace {

#define KERF_FAST                                                                                           \
  "byte_sweep=1,free_directions=0,max_redundancy=0.4,schedule_interval=2,budget_divisor=1,min_threshold=8," \
  "max_threshold=16,bulk_factor=2,"
constexpr std::array kConfigs{
    "",  // the paper's
    "free_directions=0",
    "max_redundancy=0.4,schedule_interval=1,budget_divisor=1,min_threshold=4,max_threshold=8",
    "max_redundancy=0.4,schedule_interval=1,budget_divisor=1,min_threshold=4,max_threshold=8,"
    "free_directions=0",
    "max_redundancy=0.4,schedule_interval=2,budget_divisor=2,min_threshold=6,max_threshold=12,sample=4,"
    "min_balance=0.3",
    "max_redundancy=1,repair_redundancy=1,schedule_interval=1,budget_divisor=1,min_threshold=2,"
    "max_threshold=4,max_height=6,max_entries=1.5",
    "budget_divisor=0",
    // Beyond the paper: kept pairs, sweeps by bytes, and both with everything placed anew in each step.
    KERF_FAST "skin=8,stream_share=0.06", KERF_FAST "skin=8,stream_share=1",
    KERF_FAST "skin=8,stream_share=0", KERF_FAST "skin=0,stream_share=1",
    KERF_FAST "skin=0,stream_share=0,free_directions=1",
    // Without the parts of these policies.
    KERF_FAST "skin=8,stream_share=0.06,restless=0,resting_pairs=0,leaf_boxes=0,dense=0",
    KERF_FAST "skin=0,stream_share=0.06,leaf_boxes=0,dense=0"};
#undef KERF_FAST

template <class T>
class Oracle : public testing::Test {
 protected:
  static constexpr std::uint32_t kCount = 250;
  static constexpr double kReach = 1.5;
  /// The side of a world in which `kCount` boxes have a few neighbours each.
  static double world() { return 3.5 * std::pow(kCount, 1.0 / T::value); }

  /// Runs `motion(crowd, step)` before each step, once for each configuration.
  template <class MotionOfStep>
  void run(std::uint32_t steps, MotionOfStep motion) {
    constexpr int kD = T::value;
    for (const std::string text : kConfigs) {
      SCOPED_TRACE("config " + text);
      Bsp<kD> tree(config_of(text));
      Checked<kD> checked(tree);
      MovingBoxes<kD> crowd(checked, world(), kReach, 11);
      crowd.add(kCount, 5);
      for (std::uint32_t step = 1; step <= steps && !this->HasFailure(); ++step) {
        motion(crowd, step);
        checked.step();
        ASSERT_TRUE(is_sound(tree.tree())) << "in step " << step;
      }
    }
  }
};
TYPED_TEST_SUITE(Oracle, Dimensions, DimensionNames);

TYPED_TEST(Oracle, AgreesOnRandomWalks) {
  this->run(80, [](auto& crowd, std::uint32_t) { crowd.walk(0.5); });
}

TYPED_TEST(Oracle, AgreesOnSlowWalksAndWhereSomeStandStill) {
  this->run(80, [](auto& crowd, std::uint32_t step) { crowd.walk(step % 10 == 0 ? 0 : 0.02); });
}

TYPED_TEST(Oracle, AgreesWhenSlowAndFastStretchesAlternate) {
  this->run(120, [](auto& crowd, std::uint32_t step) { crowd.walk(step % 40 < 20 ? 0.01 : 1.5); });
}

TYPED_TEST(Oracle, AgreesWhenThePolicyChangesInTheMidstOfARun) {
  constexpr int kD = TypeParam::value;
  Bsp<kD> tree(config_of(kConfigs[2]));
  Checked<kD> checked(tree);
  MovingBoxes<kD> crowd(checked, TestFixture::world(), TestFixture::kReach, 12);
  crowd.add(TestFixture::kCount, 5);
  for (std::uint32_t step = 0; step < 130; ++step) {
    if (step % 7 == 0) tree.set_config(config_of(kConfigs[step / 7 % kConfigs.size()]));
    crowd.walk(0.05);
    if (step % 5 == 0) crowd.replace(5);
    checked.step();
    ASSERT_TRUE(is_sound(tree.tree())) << "in step " << step;
  }
}

TYPED_TEST(Oracle, AgreesOnBouncingBoxes) {
  this->run(80, [](auto& crowd, std::uint32_t) { crowd.bounce(1); });
}

TYPED_TEST(Oracle, AgreesInTheStepOfATeleport) {
  this->run(60, [](auto& crowd, std::uint32_t step) {
    if (step % 12 == 0) crowd.teleport();
  });
}

TYPED_TEST(Oracle, AgreesWhenAClusterCollapsesAndExplodes) {
  this->run(60, [](auto& crowd, std::uint32_t step) {
    if (step % 30 < 15)
      crowd.gather(0.35);
    else
      crowd.gather(-0.5);
  });
}

TYPED_TEST(Oracle, AgreesWhenEverythingCoincidesForAWhile) {
  this->run(60, [](auto& crowd, std::uint32_t step) {
    if (step == 20) crowd.gather(1);
    if (step == 40) crowd.teleport();
  });
}

TYPED_TEST(Oracle, AgreesWhileTheCrowdGrowsAndShrinks) {
  this->run(90, [](auto& crowd, std::uint32_t step) {
    crowd.walk(0.5);
    if (step < 40)
      crowd.add(5, 3);
    else
      crowd.remove(9);
  });
}

TYPED_TEST(Oracle, AgreesWhenIdsAreUsedAgain) {
  this->run(60, [](auto& crowd, std::uint32_t) {
    crowd.remove(20);
    crowd.bounce(0.5);
    crowd.add(20);
    crowd.replace(10);
  });
}

TYPED_TEST(Oracle, AgreesWhenObjectsVanishWithAnUpdatePending) {
  this->run(40, [](auto& crowd, std::uint32_t) {
    crowd.walk(1);
    crowd.remove(3);
    crowd.add(5);
    crowd.remove(2);
    crowd.walk(1);
  });
}

TYPED_TEST(Oracle, AgreesWhileBoxesAreQuarantinedAndHealed) {
  this->run(60, [](auto& crowd, std::uint32_t step) {
    if (step % 3 == 0) crowd.walk(0.5);
    crowd.damage(10);
    if (step % 4 == 0) crowd.heal();
    if (step % 5 == 0) crowd.remove(4);
    if (step % 5 == 1) crowd.replace(4);
  });
}

TYPED_TEST(Oracle, AgreesOnBoxesThatGrowAndShrinkWhileMoving) {
  this->run(80, [](auto& crowd, std::uint32_t step) {
    crowd.walk(0.5);
    crowd.scale(step % 40 < 20 ? 1.08 : 1 / 1.08);
  });
}

TYPED_TEST(Oracle, AgreesOnAnEmptyWorldThatFillsAndEmptiesAgain) {
  this->run(30, [](auto& crowd, std::uint32_t step) {
    if (step % 10 == 1) crowd.remove(crowd.size());
    if (step % 10 == 4) crowd.add(1);
    if (step % 10 == 5) crowd.add(1);
    if (step % 10 == 6) crowd.add(100);
    if (crowd.size() > 0) crowd.walk(0.1);
  });
}

TYPED_TEST(Oracle, AgreesWhenParametersChangeInMidRun) {
  constexpr int kD = TypeParam::value;
  Bsp<kD> tree;
  Checked<kD> checked(tree);
  MovingBoxes<kD> crowd(checked, this->world(), this->kReach, 13);
  crowd.add(this->kCount, 4);
  for (std::uint32_t step = 1; step <= 140; ++step) {
    if (step % 10 == 0) tree.set_config(config_of(kConfigs.at(step / 10 % kConfigs.size())));
    crowd.bounce(1);
    checked.step();
    ASSERT_TRUE(is_sound(tree.tree())) << "in step " << step;
  }
}

TYPED_TEST(Oracle, AgreesWhileEveryOperatorActs) {
  constexpr int kD = TypeParam::value;
  Bsp<kD> tree(config_of(kConfigs[2]));
  Checked<kD> checked(tree);
  MovingBoxes<kD> crowd(checked, this->world(), this->kReach, 17);
  crowd.add(this->kCount);
  for (std::uint32_t step = 1; step <= 200; ++step) {
    crowd.bounce(1);
    if (step % 40 == 0) crowd.gather(0.7);
    if (step % 40 == 20) crowd.teleport();
    if (step % 40 == 30) crowd.remove(100);
    if (step % 40 == 35) crowd.add(100);
    checked.step();
    ASSERT_TRUE(is_sound(tree.tree())) << "in step " << step;
  }
  const Statistics statistics = tree.statistics();
  for (const Operator op :
       {Operator::split, Operator::shift_split, Operator::merge, Operator::balance, Operator::swap})
    EXPECT_GE(statistics.count(op), 5U) << to_string(op);
}

}  // namespace
}  // namespace kerf::test
