#include "core/bsp/mode_chooser.h"

#include <gtest/gtest.h>

namespace kerf::test {
namespace {

/// A chooser that may use bytes and skins, and has decided about the first step.
class Choice {
 public:
  explicit Choice(int dimension = 3) : chooser_(dimension) { chooser_.decide({true, true, {}, {}}); }
  [[nodiscard]] bool keeps() const { return chooser_.mode() == Mode::kept; }
  /// Decides about the step after one with swept leaves.
  void swept(const Motions& motions) { chooser_.decide({true, true, motions, {}}); }
  /// Decides about the step after one with kept pairs.
  void kept(const Leaving& leaving) { chooser_.decide({true, true, {}, leaving}); }
  /// Decides about the step after one with swept leaves, in which all objects moved alike.
  void swept_shift(const Motions& motions) { chooser_.decide({true, true, motions, {}, true}); }
  void cost(float cost) { chooser_.count_cost(cost); }
  [[nodiscard]] ModeChooser& chooser() { return chooser_; }

  /// The number of decisions until the mode changes, at most `most`.
  int swept_until_change(const Motions& motions, int most = 2000) {
    return until_change([&] { swept(motions); }, most);
  }
  int kept_until_change(const Leaving& leaving, int most = 2000) {
    return until_change([&] { kept(leaving); }, most);
  }

 private:
  template <class Step>
  int until_change(Step step, int most) {
    const Mode mode = chooser_.mode();
    int count = 0;
    while (count < most && chooser_.mode() == mode) {
      step();
      ++count;
    }
    return count;
  }

  ModeChooser chooser_;
};

/// The first motions were slow.
Choice keeping() {
  Choice choice;
  choice.swept({});
  return choice;
}

TEST(ModeChooser, AShiftOfTheOriginIsNoEvidenceOfSpeed) {
  Choice choice;
  choice.swept_shift({});
  EXPECT_FALSE(choice.keeps()) << "no speed is known yet";
  choice.swept({0.016F, 0});
  for (int k = 0; k < 3; ++k) {
    choice.swept({0.009F, 0});
    choice.swept_shift({100, 1});
    EXPECT_FALSE(choice.keeps()) << k;
  }
  choice.swept({0.009F, 0});
  EXPECT_TRUE(choice.keeps()) << "four slow steps beside the shifts";
}

TEST(ModeChooser, TheFirstSpeedsDecideAtOnce) {
  Choice mild;
  EXPECT_FALSE(mild.keeps()) << "no speed is known";
  mild.swept({0.014F, 0});
  EXPECT_TRUE(mild.keeps());
  Choice fast;
  fast.swept({0.016F, 0});
  EXPECT_FALSE(fast.keeps());
  EXPECT_EQ(fast.swept_until_change({0.014F, 0}), 2000) << "later they must be slower";
  EXPECT_EQ(fast.swept_until_change({0.009F, 0}), 4);
}

TEST(ModeChooser, KeepsAsLongAsFewLeave) {
  Choice choice = keeping();
  EXPECT_TRUE(choice.keeps());
  EXPECT_EQ(choice.kept_until_change({0.029F, {0, 0}}), 2000);
}

TEST(ModeChooser, BeginnersMayLoseMoreWhileSkinsLearnButNotForLong) {
  Choice choice = keeping();
  choice.kept({1, {0, 0}});  // no object has a fat box yet
  EXPECT_TRUE(choice.keeps());
  EXPECT_EQ(choice.kept_until_change({0.15F, {0, 0}}), 25);
  Choice hopeless = keeping();
  EXPECT_EQ(hopeless.kept_until_change({0.5F, {0, 0}}), 3);
}

TEST(ModeChooser, EachRegretDoublesTheWait) {
  Choice choice = keeping();
  int waited = 0;
  for (int turn = 0; turn < 5; ++turn) {
    choice.kept_until_change({0.5F, {0, 0}});
    const int wait = choice.swept_until_change({0.001F, 0});
    if (turn > 0) {
      EXPECT_EQ(wait, 2 * waited);
    }
    waited = wait;
  }
  choice.kept_until_change({0.01F, {0, 0}}, 500);
  choice.kept_until_change({0.5F, {0, 0}});
  EXPECT_EQ(choice.swept_until_change({0.001F, 0}), 8) << "it paid for long";
}

TEST(ModeChooser, KeepingThatPaidIsNoRegret) {
  Choice choice = keeping();
  for (int turn = 0; turn < 3; ++turn) {
    EXPECT_EQ(choice.kept_until_change({}, 30), 30);
    choice.kept_until_change({0.5F, {}});
    EXPECT_EQ(choice.swept_until_change({0.001F, 0}), 4) << turn;
  }
}

TEST(ModeChooser, ObjectsThatBecomeTooFastAreCheaperThanThoseThatGetAnotherFatBox) {
  Choice choice = keeping();
  EXPECT_EQ(choice.kept_until_change({0.11F, {0, 1}}), 2000);
  EXPECT_EQ(choice.kept_until_change({0.13F, {0, 1}}), 3);
}

TEST(ModeChooser, SweepsOnWhileObjectsDrift) {
  Choice choice = keeping();
  choice.kept_until_change({0.5F, {0, 0}});
  EXPECT_EQ(choice.swept_until_change({0.02F, 0}), 2000);
}

TEST(ModeChooser, KeepsBesideSomeFastObjectsAndBesideMoreOfThemIn2D) {
  for (const int dimension : {2, 3}) {
    Choice some(dimension);
    some.swept({0.001F, 0.1F});
    EXPECT_TRUE(some.keeps()) << dimension;
    Choice more(dimension);
    more.swept({0.001F, 0.3F});
    EXPECT_EQ(more.keeps(), dimension == 2);
    Choice most(dimension);
    EXPECT_EQ(most.swept_until_change({0.001F, 0.5F}), 2000) << dimension;
  }
}

TEST(ModeChooser, CostsAreBelievedBeforeTheNextStepAndNotTriedSoonAgainUntilFewAreFast) {
  Choice choice = keeping();
  choice.cost(0.8F);
  choice.kept({});
  EXPECT_TRUE(choice.keeps());
  choice.cost(0.9F);
  EXPECT_TRUE(choice.keeps()) << "nothing changes the mode within a step";
  Choice resumed;
  resumed.chooser().resume(choice.chooser().mode(), choice.chooser().memory());
  for (Choice* const each : {&choice, &resumed}) {
    each->kept({});
    ASSERT_FALSE(each->keeps());
    EXPECT_EQ(each->chooser().taken()->condition, Condition::keeping_is_costly);
  }
  EXPECT_EQ(resumed.swept_until_change({0.001F, 0.1F}), 512);
  EXPECT_LE(choice.swept_until_change({0.001F, 0.05F}), 8);
}

TEST(ModeChooser, OneUproarIsEnoughUnlessItIsMild) {
  for (const Motions& wild : {Motions{0.05F, 0}, Motions{0, 0.9F}}) {
    Choice choice = keeping();
    choice.kept_until_change({0.3F, wild}, 1);
    EXPECT_TRUE(choice.keeps()) << "skins learn";
    choice.kept_until_change({}, 30);
    EXPECT_EQ(choice.kept_until_change({0.3F, wild}), 1);
  }
  Choice choice = keeping();
  choice.kept_until_change({}, 30);
  EXPECT_EQ(choice.kept_until_change({0.3F, {0.01F, 0}}), 3);
}

TEST(ModeChooser, WhatIsNotAllowedIsForgotten) {
  Choice choice = keeping();
  choice.kept_until_change({0.5F, {0, 0}});
  choice.chooser().decide({true, false, {}, {}});
  EXPECT_EQ(choice.chooser().mode(), Mode::swept);
  EXPECT_EQ(choice.chooser().memory(), ModeChooser(3).memory());
  choice.swept({0.014F, 0});
  EXPECT_TRUE(choice.keeps()) << "the first motions decide at once again";
  choice.chooser().decide({false, true, {}, {}});
  EXPECT_EQ(choice.chooser().mode(), Mode::ordered);
}

}  // namespace
}  // namespace kerf::test
