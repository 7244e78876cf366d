#include "core/bsp/keep_or_sweep.h"

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
  choice.swept({}, 3);
  return choice;
}

TEST(KeepOrSweep, TheFirstSpeedsDecideAtOnce) {
  KeepOrSweep mild;
  EXPECT_FALSE(mild.keeps()) << "nobody's speed is known";
  mild.swept({0.014F, 0}, 3);
  EXPECT_TRUE(mild.keeps());
  KeepOrSweep fast;
  fast.swept({0.016F, 0}, 3);
  EXPECT_FALSE(fast.keeps());
  EXPECT_EQ(steps_until_change(fast,
                               [&] {
                                 fast.swept({0.014F, 0}, 3);
                               }),
            2000)
      << "later they must be slower";
  EXPECT_EQ(steps_until_change(fast, [&] { fast.swept({0.009F, 0}, 3); }), 4);
}

TEST(KeepOrSweep, KeepsAsLongAsFewLeave) {
  KeepOrSweep choice = keeping();
  EXPECT_TRUE(choice.keeps());
  EXPECT_EQ(steps_until_change(choice, [&] { choice.kept({0.029F, {0, 0}}, 3); }), 2000);
}

TEST(KeepOrSweep, BeginnersMayLoseMoreWhileSkinsLearnButNotForLong) {
  KeepOrSweep choice = keeping();
  choice.kept({1, {0, 0}}, 3);  // no object has a fat box yet
  EXPECT_TRUE(choice.keeps());
  EXPECT_EQ(steps_until_change(choice, [&] { choice.kept({0.15F, {0, 0}}, 3); }), 25);
  KeepOrSweep hopeless = keeping();
  EXPECT_EQ(steps_until_change(hopeless, [&] { hopeless.kept({0.5F, {0, 0}}, 3); }), 3);
}

TEST(KeepOrSweep, WhoRegretsWaitsTwiceAsLongEachTime) {
  KeepOrSweep choice = keeping();
  int waited = 0;
  for (int turn = 0; turn < 5; ++turn) {
    steps_until_change(choice, [&] { choice.kept({0.5F, {0, 0}}, 3); });
    const int wait = steps_until_change(choice, [&] { choice.swept({0.001F, 0}, 3); });
    if (turn > 0) {
      EXPECT_EQ(wait, 2 * waited);
    }
    waited = wait;
  }
  steps_until_change(
      choice,
      [&] {
        choice.kept({0.01F, {0, 0}}, 3);
      },
      500);
  steps_until_change(choice, [&] { choice.kept({0.5F, {0, 0}}, 3); });
  EXPECT_EQ(steps_until_change(choice, [&] { choice.swept({0.001F, 0}, 3); }), 8) << "it paid for long";
}

TEST(KeepOrSweep, WhoKeptUntilItPaidDoesNotWaitLonger) {
  KeepOrSweep choice = keeping();
  for (int turn = 0; turn < 3; ++turn) {
    EXPECT_EQ(steps_until_change(
                  choice, [&] { choice.kept({}, 3); }, 30),
              30);
    steps_until_change(choice, [&] { choice.kept({0.5F, {}}, 3); });
    EXPECT_EQ(steps_until_change(choice, [&] { choice.swept({0.001F, 0}, 3); }), 4) << turn;
  }
}

TEST(KeepOrSweep, WhoBecomesTooFastIsCheaperThanWhoGetsAnotherFatBox) {
  KeepOrSweep choice = keeping();
  EXPECT_EQ(steps_until_change(choice, [&] { choice.kept({0.11F, {0, 1}}, 3); }), 2000);
  EXPECT_EQ(steps_until_change(choice, [&] { choice.kept({0.13F, {0, 1}}, 3); }), 3);
}

TEST(KeepOrSweep, SweepsOnWhileObjectsDrift) {
  KeepOrSweep choice = keeping();
  steps_until_change(choice, [&] { choice.kept({0.5F, {0, 0}}, 3); });
  EXPECT_EQ(steps_until_change(choice, [&] { choice.swept({0.02F, 0}, 3); }), 2000);
}

TEST(KeepOrSweep, KeepsBesideSomeFastObjectsAndBesideMoreOfThemIn2D) {
  for (const int dimension : {2, 3}) {
    KeepOrSweep some;
    some.swept({0.001F, 0.1F}, dimension);
    EXPECT_TRUE(some.keeps()) << dimension;
    KeepOrSweep more;
    more.swept({0.001F, 0.3F}, dimension);
    EXPECT_EQ(more.keeps(), dimension == 2);
    KeepOrSweep most;
    EXPECT_EQ(steps_until_change(most, [&] { most.swept({0.001F, 0.5F}, dimension); }), 2000) << dimension;
  }
}

TEST(KeepOrSweep, WhatIsDearIsNotTriedSoonAgainUntilFewAreFast) {
  KeepOrSweep choice = keeping();
  choice.kept_at(0.8F);
  EXPECT_TRUE(choice.keeps());
  choice.kept_at(0.9F);
  EXPECT_FALSE(choice.keeps());
  KeepOrSweep resumed;
  resumed.resume(choice.memory());
  EXPECT_EQ(steps_until_change(resumed, [&] { resumed.swept({0.001F, 0.1F}, 3); }), 512);
  EXPECT_LE(steps_until_change(choice, [&] { choice.swept({0.001F, 0.05F}, 3); }), 8);
}

TEST(KeepOrSweep, OneUproarIsEnoughUnlessItIsMild) {
  for (const Motions& wild : {Motions{0.05F, 0}, Motions{0, 0.9F}}) {
    KeepOrSweep choice = keeping();
    steps_until_change(
        choice,
        [&] {
          choice.kept({0.3F, wild}, 3);
        },
        1);
    EXPECT_TRUE(choice.keeps()) << "skins learn";
    steps_until_change(
        choice, [&] { choice.kept({}, 3); }, 30);
    EXPECT_EQ(steps_until_change(choice, [&] { choice.kept({0.3F, wild}, 3); }), 1);
  }
  KeepOrSweep choice = keeping();
  steps_until_change(
      choice, [&] { choice.kept({}, 3); }, 30);
  EXPECT_EQ(steps_until_change(choice, [&] { choice.kept({0.3F, {0.01F, 0}}, 3); }), 3);
}

}  // namespace
}  // namespace kerf::test
