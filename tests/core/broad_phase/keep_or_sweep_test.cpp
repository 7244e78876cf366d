#include "core/broad_phase/keep_or_sweep.h"

#include <gtest/gtest.h>

namespace kerf::test {
namespace {

/// Steps until the mode changes, at most `most`.
template <class Step>
int steps_until_change(KeepOrSweep& choice, Step step, int most = 2000) {
  const bool keeps = choice.keeps();
  int count = 0;
  while (count < most && choice.keeps() == keeps) {
    step();
    ++count;
  }
  return count;
}

/// It has seen a first step of objects that were slow.
KeepOrSweep keeping() {
  KeepOrSweep choice;
  choice.swept(0);
  return choice;
}

TEST(KeepOrSweep, TheFirstSpeedsDecideAtOnce) {
  KeepOrSweep mild;
  EXPECT_FALSE(mild.keeps()) << "nobody's speed is known";
  mild.swept(0.014F);
  EXPECT_TRUE(mild.keeps());
  KeepOrSweep fast;
  fast.swept(0.016F);
  EXPECT_FALSE(fast.keeps());
  EXPECT_EQ(steps_until_change(fast, [&] { fast.swept(0.014F); }), 2000) << "later they must be slower";
  EXPECT_EQ(steps_until_change(fast, [&] { fast.swept(0.009F); }), 4);
}

TEST(KeepOrSweep, KeepsAsLongAsFewLeave) {
  KeepOrSweep choice = keeping();
  EXPECT_TRUE(choice.keeps());
  EXPECT_EQ(steps_until_change(choice, [&] { choice.kept({0.029F, 1, 0}); }), 2000);
}

TEST(KeepOrSweep, BeginnersMayLoseMoreWhileSkinsLearnButNotForLong) {
  KeepOrSweep choice = keeping();
  choice.kept({1, 0.01F, 0});  // nobody has a fat box yet
  EXPECT_TRUE(choice.keeps());
  EXPECT_EQ(steps_until_change(choice, [&] { choice.kept({0.15F, 0.01F, 0}); }), 25);
  KeepOrSweep hopeless = keeping();
  EXPECT_EQ(steps_until_change(hopeless, [&] { hopeless.kept({0.5F, 0.01F, 0}); }), 3);
}

TEST(KeepOrSweep, OneStepOfFastObjectsIsEnough) {
  KeepOrSweep choice = keeping();
  choice.kept({1, 0.5F, 0});
  EXPECT_FALSE(choice.keeps());
}

TEST(KeepOrSweep, WhoRegretsWaitsTwiceAsLongEachTime) {
  KeepOrSweep choice = keeping();
  int waited = 0;
  for (int turn = 0; turn < 5; ++turn) {
    steps_until_change(choice, [&] { choice.kept({0.5F, 0.01F, 0}); });
    const int wait = steps_until_change(choice, [&] { choice.swept(0.001F); });
    if (turn > 0) {
      EXPECT_EQ(wait, 2 * waited);
    }
    waited = wait;
  }
  steps_until_change(
      choice,
      [&] {
        choice.kept({0.01F, 0, 0});
      },
      500);
  steps_until_change(choice, [&] { choice.kept({0.5F, 0.01F, 0}); });
  EXPECT_EQ(steps_until_change(choice, [&] { choice.swept(0.001F); }), 8) << "it paid for long";
}

TEST(KeepOrSweep, RestlessObjectsAreCheaperThanThoseThatGetAnotherFatBox) {
  KeepOrSweep choice = keeping();
  EXPECT_EQ(steps_until_change(choice, [&] { choice.kept({0.07F, 0.5F, 1}); }), 2000);
  EXPECT_EQ(steps_until_change(choice, [&] { choice.kept({0.08F, 0.5F, 1}); }), 1);
}

TEST(KeepOrSweep, SweepsOnWhileObjectsAreFast) {
  KeepOrSweep choice = keeping();
  choice.kept({1, 0.5F, 0});
  EXPECT_EQ(steps_until_change(choice, [&] { choice.swept(0.02F); }), 2000);
}

}  // namespace
}  // namespace kerf::test
