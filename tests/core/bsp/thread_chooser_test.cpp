#include "core/bsp/thread_chooser.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace kerf::test {
namespace {

/// A machine on which a step takes one time alone and another one shared.
struct Machine {
  double alone = 1;
  double shared = 1;
};

/// What a chooser chose in some steps.
struct Course {
  std::uint32_t shared = 0;  ///< steps
  double seconds = 0;
};

/// Steps on a machine, whose way the chooser decides from one to the next.
class ChoosingSteps {
 public:
  Course run(const Machine& machine, std::uint32_t steps, Mode mode = Mode::swept) {
    Course course;
    for (std::uint32_t step = 0; step < steps; ++step) {
      const double slow = since_change_++ < slow_after_change ? 10 : 1;
      const double seconds = slow * (shares_ ? machine.shared : machine.alone);
      course.shared += shares_ ? 1 : 0;
      course.seconds += seconds;
      const bool shares = chooser_.choose(mode, objects, seconds);
      if (shares != shares_) since_change_ = 0;
      shares_ = shares;
    }
    return course;
  }

  std::uint32_t objects = 10000;
  std::uint32_t slow_after_change = 0;  ///< steps that take ten times as long after a change of the way

 private:
  ThreadChooser chooser_;
  bool shares_ = false;
  std::uint32_t since_change_ = 10;
};

TEST(ThreadChooser, GoesOnWithTheFasterWay) {
  ChoosingSteps gains;
  (void)gains.run({1, 0.6}, 20);
  EXPECT_EQ(gains.run({1, 0.6}, 50).shared, 50U);
  ChoosingSteps loses;
  (void)loses.run({1, 1.4}, 20);
  EXPECT_EQ(loses.run({1, 1.4}, 50).shared, 0U);
  ChoosingSteps neither;
  (void)neither.run({1, 0.97}, 20);
  EXPECT_EQ(neither.run({1, 0.97}, 50).shared, 0U) << "the other cores are left to others";
}

TEST(ThreadChooser, ATrialThatLosesMuchIsRepeatedLate) {
  for (const double shared : {0.5, 0.9, 1.1, 2.0, 25.0}) {
    ChoosingSteps steps;
    (void)steps.run({1, shared}, 20);
    const Course course = steps.run({1, shared}, 20000);
    EXPECT_LT(course.seconds, 20000 * std::min(1.0, shared) * 1.03) << shared;
  }
}

TEST(ThreadChooser, SeesThatTheMachineHasChanged) {
  ChoosingSteps steps;
  (void)steps.run({1, 0.6}, 200);
  (void)steps.run({1, 3}, 200);
  EXPECT_EQ(steps.run({1, 3}, 30).shared, 0U);
  (void)steps.run({1, 0.6}, 1000);
  EXPECT_EQ(steps.run({1, 0.6}, 30).shared, 30U);
}

TEST(ThreadChooser, OneSlowStepDecidesNothing) {
  for (std::uint32_t slow = 0; slow < ThreadChooser::kTrialSteps; ++slow) {
    ChoosingSteps steps;
    (void)steps.run({1, 0.6}, ThreadChooser::kStepsBefore + 1 + slow);
    (void)steps.run({900, 900}, 1);
    (void)steps.run({1, 0.6}, ThreadChooser::kTrialSteps);
    EXPECT_EQ(steps.run({1, 0.6}, 30).shared, 30U) << slow;
    (void)steps.run({1, 2}, 300);
    EXPECT_EQ(steps.run({1, 2}, 30).shared, 0U) << slow << ": the next trial is not late for it";
  }
}

/// As while a tree is built, or while skins learn.
TEST(ThreadChooser, TimesThatFallFavourNeitherWay) {
  ChoosingSteps steps;
  for (std::uint32_t step = 0; step < 20; ++step) (void)steps.run({20.0 - step, 1.1 * (20.0 - step)}, 1);
  EXPECT_EQ(steps.run({1, 1.1}, 30).shared, 0U);
}

/// As where caches are filled anew, and threads wake.
TEST(ThreadChooser, StepsAfterAChangeOfTheWayDecideNothing) {
  ChoosingSteps steps;
  steps.slow_after_change = 2;
  (void)steps.run({1, 0.6}, 20);
  EXPECT_EQ(steps.run({1, 0.6}, 30).shared, 30U);
}

TEST(ThreadChooser, ModesThatChangeAreNotTriedEachTime) {
  ChoosingSteps steps;
  std::uint32_t shared = 0;
  for (std::uint32_t turn = 0; turn < 100; ++turn)
    shared += steps.run({1, 3}, 10, turn % 2 == 0 ? Mode::swept : Mode::kept).shared;
  EXPECT_LE(shared, 130U);
}

/// As a pile at rest that is kicked: same mode, other work.
TEST(ThreadChooser, AnotherTimeIsTriedSoon) {
  ChoosingSteps steps;
  (void)steps.run({1, 25}, 100);
  (void)steps.run({60, 36}, 25);
  EXPECT_EQ(steps.run({60, 36}, 30).shared, 30U);
}

TEST(ThreadChooser, CrowdsThatSwingAreNotTriedInEachSwing) {
  ChoosingSteps steps;
  std::uint32_t shared = 0;
  for (std::uint32_t swing = 0; swing < 100; ++swing) {
    steps.objects = swing % 2 == 0 ? 3000 : 10000;
    shared += steps.run({1, 3}, 20).shared;
  }
  EXPECT_LE(shared, 2000 / ThreadChooser::kLeastWait * 4);
}

TEST(ThreadChooser, FewObjectsAreNeverShared) {
  ChoosingSteps steps;
  steps.objects = ThreadChooser::kFew - 1;
  EXPECT_EQ(steps.run({1, 0.1}, 500).shared, 0U);
  steps.objects = ThreadChooser::kFew;
  (void)steps.run({1, 0.1}, 50);
  EXPECT_EQ(steps.run({1, 0.1}, 10).shared, 10U);
  steps.objects = 10;
  (void)steps.run({1, 0.1}, 1);
  EXPECT_EQ(steps.run({1, 0.1}, 10).shared, 0U);
}

TEST(ThreadChooser, ManyObjectsAreSharedUntilATrialEnds) {
  ChoosingSteps steps;
  steps.objects = ThreadChooser::kMany;
  (void)steps.run({1, 3}, 1);
  EXPECT_EQ(steps.run({1, 3}, 2).shared, 2U);
}

TEST(ThreadChooser, AnotherCrowdIsTriedAnew) {
  ChoosingSteps steps;
  (void)steps.run({1, 25}, 100);
  steps.objects *= 4;
  (void)steps.run({1, 0.6}, 16);
  EXPECT_EQ(steps.run({1, 0.6}, 30).shared, 30U);
}

TEST(ThreadChooser, EachModeHasItsWay) {
  ChoosingSteps steps;
  (void)steps.run({1, 0.6}, 30, Mode::swept);
  (void)steps.run({1, 2}, 30, Mode::kept);
  EXPECT_EQ(steps.run({1, 2}, 20, Mode::kept).shared, 0U);
  (void)steps.run({1, 0.6}, 1, Mode::swept);
  EXPECT_EQ(steps.run({1, 0.6}, 20, Mode::swept).shared, 20U) << "it is known from before";
}

}  // namespace
}  // namespace kerf::test
