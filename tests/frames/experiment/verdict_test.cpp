#include "frames/experiment/verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "frames/experiment/spread.h"

namespace kerf {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Samples = std::vector<double>;

constexpr std::string_view kBsp = "kerf-paper";
constexpr std::string_view kQt = "ode-quadtree";
constexpr std::string_view kSh = "ode-hash";
constexpr std::string_view kLo = "loose-octree";
constexpr std::string_view kSp = "sweep-and-prune";

/// The one claim of a simulation that begins with these words.
const Claim& claim(int simulation, std::string_view words) {
  const auto found = std::ranges::find_if(
      claims(), [&](const Claim& c) { return c.simulation == simulation && c.words.starts_with(words); });
  if (found == claims().end()) throw std::logic_error("no claim " + std::string(words));
  return *found;
}

/// Five runs around a value, of which none differs by more than 4 %.
Samples about(double value) { return {value, value * 1.02, value * 0.98, value * 1.01, value * 0.99}; }

ClaimFigures figures(int simulation, Measure measure, const std::map<std::string_view, Samples>& samples) {
  ClaimFigures figures;
  for (const auto& [contestant, values] : samples) figures[{simulation, contestant, measure}] = values;
  return figures;
}

ClaimVerdict judged(int simulation, std::string_view words, Measure measure,
                    const std::map<std::string_view, Samples>& samples) {
  return judge(claim(simulation, words), figures(simulation, measure, samples));
}

TEST(Spread, LeavesOutATenthAtEitherEnd) {
  Samples samples;
  for (int k = 1; k <= 15; ++k) samples.push_back(k);
  samples[0] = 1000;
  const auto spread = spread_of(samples);
  ASSERT_TRUE(spread);
  EXPECT_EQ(spread->median, 9);
  EXPECT_EQ(spread->low, 3);
  EXPECT_EQ(spread->high, 15);
  EXPECT_EQ(spread->samples, 15U);
  EXPECT_EQ(spread_of({3, 1, 2})->low, 1);
  EXPECT_EQ(spread_of({1, 2})->median, 1.5);
}

TEST(Spread, IsNoneWhereAFigureIsMissing) {
  EXPECT_FALSE(spread_of({}));
  EXPECT_FALSE(spread_of({1, std::nan(""), 2}));
}

// The faults of earlier verdicts.

TEST(Verdict, HigherCollisionTimeIsJudgedByCollisionTimeAndWithTheHash) {
  const char* words = "at the expense of higher collision time";
  const ClaimVerdict verdict = judged(
      1, words, Measure::collision, {{kSp, about(0.1)}, {kSh, about(5)}, {kBsp, about(1)}, {kLo, about(2)}});
  EXPECT_EQ(verdict.outcome, Outcome::partly) << "SH is slower, SP is not";
  EXPECT_EQ(verdict.standing, Standing::worse);
  EXPECT_THAT(verdict.reason, HasSubstr("SP is 0.1 times BSP, not more"));
}

TEST(Verdict, ASmallAdvantageIsNotOneByAFactorOf43) {
  const ClaimVerdict verdict =
      judged(3, "and in time", Measure::collision, {{kBsp, about(1)}, {kQt, about(43)}});
  EXPECT_EQ(verdict.outcome, Outcome::partly);
  EXPECT_EQ(verdict.standing, Standing::better);
  EXPECT_EQ(text_of_standing(verdict), "better for BSP");
  EXPECT_THAT(verdict.reason, HasSubstr("much less, not slightly"));
  EXPECT_EQ(judged(3, "and in time", Measure::collision, {{kBsp, about(1)}, {kQt, about(1.3)}}).outcome,
            Outcome::holds);
  EXPECT_EQ(judged(3, "and in time", Measure::collision, {{kBsp, about(2)}, {kQt, about(1)}}).outcome,
            Outcome::opposite);
}

TEST(Verdict, ScalingIsJudgedByCollisionTimeAndOverheadByOverhead) {
  for (const Comparison& comparison : claim(4, "SP has the worst scaling").comparisons)
    EXPECT_EQ(comparison.subject.measure, Measure::object_collision_growth);
  for (const Comparison& comparison : claim(4, "SH has the worst overhead time").comparisons)
    EXPECT_EQ(comparison.subject.measure, Measure::overhead);
}

TEST(Verdict, SimilarIsWithinTheTolerance) {
  const auto outcome = [](double sp) {
    return judged(4, "SP has overhead times similar", Measure::overhead, {{kSp, about(sp)}, {kBsp, about(1)}})
        .outcome;
  };
  EXPECT_EQ(outcome(1.4), Outcome::holds);
  EXPECT_EQ(outcome(1 / 1.4), Outcome::holds);
  EXPECT_EQ(outcome(1.6), Outcome::opposite);
  EXPECT_EQ(outcome(1 / 1.6), Outcome::opposite);
}

TEST(Verdict, WhatIsBetterThanThePaperIsCalledSo) {
  const ClaimVerdict verdict =
      judged(3, "but higher overhead", Measure::overhead, {{kBsp, about(1)}, {kQt, about(4)}});
  EXPECT_EQ(verdict.outcome, Outcome::opposite);
  EXPECT_EQ(text_of_standing(verdict), "better for BSP");
  const ClaimVerdict of_octree =
      judged(2, "SH and LO show similar", Measure::overhead, {{kSh, about(7)}, {kLo, about(1)}});
  EXPECT_EQ(of_octree.outcome, Outcome::opposite);
  EXPECT_EQ(text_of_standing(of_octree), "better for LO") << "LO is ours, too; SH is not";
}

TEST(Verdict, MoreFramesAreBetter) {
  const char* words = "BSP is similar to QT at the start";
  const ClaimVerdict verdict =
      judged(3, words, Measure::frames_before, {{kBsp, about(90)}, {kQt, about(30)}});
  EXPECT_EQ(verdict.outcome, Outcome::opposite);
  EXPECT_EQ(verdict.standing, Standing::better);
}

// What figures can be.

TEST(Verdict, HoldsWhereAllComparisonsDo) {
  const ClaimVerdict verdict =
      judged(3, "LO has the worst collision time", Measure::collision,
             {{kLo, about(9)}, {kBsp, about(1)}, {kQt, about(2)}, {kSh, about(3)}, {kSp, about(4)}});
  EXPECT_EQ(verdict.outcome, Outcome::holds);
  EXPECT_EQ(verdict.standing, Standing::as_the_paper);
  EXPECT_EQ(text_of_standing(verdict), "as the paper");
  EXPECT_THAT(verdict.reason, IsEmpty());
  EXPECT_THAT(verdict.figures, HasSubstr("collision time: LO 9 (8.82 to 9.18), BSP 1 (0.98 to 1.02)"));
  EXPECT_THAT(verdict.figures, HasSubstr(" ms"));
}

TEST(Verdict, IsPartlyWithHalfOfTheComparisonsAndOppositeWithFewer) {
  const auto outcome = [](double lo) {
    return judged(3, "LO has the worst collision time", Measure::collision,
                  {{kLo, about(lo)}, {kBsp, about(1)}, {kQt, about(2)}, {kSh, about(3)}, {kSp, about(4)}})
        .outcome;
  };
  EXPECT_EQ(outcome(2.5), Outcome::partly);
  EXPECT_EQ(outcome(1.5), Outcome::opposite);
  EXPECT_EQ(outcome(0.5), Outcome::opposite);
}

TEST(Verdict, IsOpenWhereSpreadsOverlap) {
  const Samples wide{0.5, 0.9, 1, 1.4, 2};
  const ClaimVerdict verdict =
      judged(1, "the BSP overhead is worse than QT", Measure::overhead, {{kBsp, wide}, {kQt, about(1)}});
  EXPECT_EQ(verdict.outcome, Outcome::cannot_be_judged);
  EXPECT_EQ(verdict.standing, Standing::unknown);
  EXPECT_EQ(text_of_standing(verdict), "");
  EXPECT_THAT(verdict.reason, HasSubstr("leaves it open"));
  EXPECT_EQ(
      judged(4, "SP has overhead times similar", Measure::overhead, {{kSp, wide}, {kBsp, about(1)}}).outcome,
      Outcome::cannot_be_judged);
}

/// Both differ from run to run by more than from each other, but always in the same direction.
TEST(Verdict, ComparesRunByRun) {
  const ClaimVerdict verdict = judged(1, "the BSP overhead is worse than QT", Measure::overhead,
                                      {{kBsp, {1.2, 2.4, 4.8}}, {kQt, {1, 2, 4}}});
  EXPECT_EQ(verdict.outcome, Outcome::holds);
}

TEST(Verdict, FiguresThatAreAlikeAreNotOneLessThanTheOther) {
  const ClaimVerdict verdict = judged(2, "SP generates less pairs", Measure::pairs,
                                      {{kSp, {100, 100, 100}},
                                       {kBsp, {100, 101, 99}},
                                       {kQt, about(100)},
                                       {kSh, about(100)},
                                       {kLo, about(100)}});
  EXPECT_NE(verdict.outcome, Outcome::holds);
  EXPECT_EQ(judged(1, "the BSP overhead is better than SH", Measure::overhead,
                   {{kBsp, {1, 1, 1}}, {kSh, {1, 1, 1}}})
                .outcome,
            Outcome::partly);
}

/// By 1 % in every run.
TEST(Verdict, FiguresWithinTwoPercentAreAlikeInAllRuns) {
  const char* words = "the BSP overhead is better than SH";
  for (const double bsp : {99.0, 101.0}) {
    const ClaimVerdict verdict =
        judged(1, words, Measure::overhead, {{kBsp, {bsp, bsp, bsp}}, {kSh, {100, 100, 100}}});
    EXPECT_EQ(verdict.outcome, Outcome::partly);
    EXPECT_THAT(verdict.reason, HasSubstr("alike"));
  }
}

TEST(Verdict, WhatMayBeSlightIsNotCalledMuch) {
  const ClaimVerdict verdict =
      judged(3, "and in time", Measure::collision, {{kBsp, {0.6, 0.7, 0.8}}, {kQt, {1, 1, 1}}});
  EXPECT_EQ(verdict.outcome, Outcome::partly);
  EXPECT_THAT(verdict.reason, HasSubstr("less and not surely slightly"));
}

/// That a tree adapts late, or gains much in one simulation, is neither better nor worse than it is said to.
TEST(Verdict, SomeFiguresAreNoMerit) {
  const ClaimVerdict verdict = judged(3, "BSP depth changed in a faster ratio", Measure::depth_after_fracture,
                                      {{kBsp, {0.5, 0.5, 0.5}}});
  EXPECT_EQ(verdict.outcome, Outcome::opposite);
  EXPECT_EQ(text_of_standing(verdict), "");
}

TEST(Verdict, MuchIsMoreThanTheTolerance) {
  const auto outcome = [](double bsp) {
    return judged(4, "but in a much faster way", Measure::collision, {{kBsp, about(bsp)}, {kSh, about(1)}})
        .outcome;
  };
  EXPECT_EQ(outcome(0.5), Outcome::holds);
  EXPECT_EQ(outcome(0.8), Outcome::partly);
  EXPECT_EQ(outcome(2), Outcome::opposite);
}

TEST(Verdict, IsOpenWithoutAFigure) {
  const char* words = "the BSP overhead is worse than QT";
  const ClaimVerdict missing = judged(1, words, Measure::overhead, {{kBsp, about(1)}});
  EXPECT_EQ(missing.outcome, Outcome::cannot_be_judged);
  EXPECT_THAT(missing.reason, HasSubstr("no figure of QT"));
  EXPECT_THAT(missing.figures, HasSubstr("QT -"));
  const ClaimVerdict not_counted =
      judged(1, words, Measure::overhead, {{kBsp, about(1)}, {kQt, {1, 2, std::nan("")}}});
  EXPECT_EQ(not_counted.outcome, Outcome::cannot_be_judged);
  EXPECT_EQ(judge(claim(1, words), {}).outcome, Outcome::cannot_be_judged);
}

TEST(Verdict, IsOpenWithFewerThanThreeRuns) {
  const char* words = "the BSP overhead is worse than QT";
  const ClaimVerdict one = judged(1, words, Measure::overhead, {{kBsp, {9}}, {kQt, {1}}});
  EXPECT_EQ(one.outcome, Outcome::cannot_be_judged);
  EXPECT_THAT(one.reason, HasSubstr("too few runs: 1"));
  EXPECT_EQ(judged(1, words, Measure::overhead, {{kBsp, {9, 9}}, {kQt, {1, 1}}}).outcome,
            Outcome::cannot_be_judged);
  EXPECT_EQ(judged(1, words, Measure::overhead, {{kBsp, {9, 9, 9}}, {kQt, {1, 1, 1}}}).outcome,
            Outcome::holds);
}

TEST(Verdict, IsOpenWhereTheRunsDiffer) {
  const ClaimVerdict verdict = judged(1, "the BSP overhead is worse than QT", Measure::overhead,
                                      {{kBsp, {9, 9, 9, 9}}, {kQt, {1, 1, 1}}});
  EXPECT_EQ(verdict.outcome, Outcome::cannot_be_judged);
}

/// Three of four are decided, and the fourth would not change what they say.
TEST(Verdict, WhatOneMissingFigureCannotChangeIsDecided) {
  const char* words = "QT has the best overhead time";
  EXPECT_EQ(judged(2, words, Measure::overhead,
                   {{kQt, about(3)}, {kBsp, about(1)}, {kLo, about(1)}, {kSp, about(1)}})
                .outcome,
            Outcome::opposite);
  EXPECT_EQ(judged(2, words, Measure::overhead,
                   {{kQt, about(1)}, {kBsp, about(2)}, {kLo, about(2)}, {kSp, about(2)}})
                .outcome,
            Outcome::cannot_be_judged)
      << "SH may be better or not";
  const ClaimVerdict open = judged(
      2, words, Measure::overhead,
      {{kQt, about(2)}, {kBsp, about(1)}, {kLo, about(3)}, {kSp, {1, 2, 3, 4, 5}}, {kSh, {1, 2, 3, 4, 5}}});
  EXPECT_EQ(open.outcome, Outcome::cannot_be_judged);
  EXPECT_EQ(open.standing, Standing::unknown) << "although BSP alone is better here";
  EXPECT_EQ(judged(2, words, Measure::overhead,
                   {{kQt, about(2)}, {kBsp, about(1)}, {kLo, about(3)}, {kSp, about(3)}})
                .outcome,
            Outcome::partly);
}

TEST(Verdict, BesideANumberNamesTheFigure) {
  ClaimFigures figures;
  for (const int simulation : {1, 2, 3, 4}) figures[{simulation, kBsp, Measure::depth_change}] = {1, 1, 2};
  const char* words = "BSP-tree depths";
  EXPECT_EQ(judge(claim(0, words), figures).outcome, Outcome::holds);
  figures[{2, kBsp, Measure::depth_change}] = {5, 6, 7};
  const ClaimVerdict verdict = judge(claim(0, words), figures);
  EXPECT_EQ(verdict.outcome, Outcome::partly);
  EXPECT_EQ(verdict.standing, Standing::worse);
  EXPECT_THAT(verdict.reason, HasSubstr("BSP is 6 (5 to 7), not less than 3.5"));
  figures[{2, kBsp, Measure::depth_change}] = {4, 4, 4};
  EXPECT_EQ(judge(claim(0, words), figures).outcome, Outcome::partly) << "four levels are not at most three";
  EXPECT_THAT(judge(claim(0, words), figures).reason, HasSubstr("BSP is 4, not less than 3.5"));
}

TEST(Verdict, OneSimulationSufficesForSomeCases) {
  ClaimFigures figures;
  for (const int simulation : {1, 2, 3, 4}) {
    figures[{simulation, kBsp, Measure::pairs}] = about(1);
    figures[{simulation, kQt, Measure::pairs}] = about(simulation == 2 ? 1.2 : 9);
  }
  const char* words = "in some cases a number of collision pairs similar to QT";
  EXPECT_EQ(judge(claim(0, words), figures).outcome, Outcome::holds);
  figures[{2, kQt, Measure::pairs}] = about(9);
  EXPECT_EQ(judge(claim(0, words), figures).outcome, Outcome::opposite);
}

TEST(Claims, EachIsJudgedByFiguresOrSaysWhyItCannotBe) {
  int without = 0;
  for (const Claim& one : claims()) {
    EXPECT_TRUE(one.section == "6.2" || one.section == "7") << one.words;
    if (!one.comparisons.empty()) continue;
    ++without;
    const ClaimVerdict verdict = judge(one, {});
    EXPECT_EQ(verdict.outcome, Outcome::cannot_be_judged);
    EXPECT_FALSE(verdict.reason.empty()) << one.words;
  }
  EXPECT_GT(without, 0);
  EXPECT_LT(2 * without, static_cast<int>(claims().size()));
}

}  // namespace
}  // namespace kerf
