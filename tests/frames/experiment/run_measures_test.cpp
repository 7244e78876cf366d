#include "frames/experiment/run_measures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "frames/experiment/claim.h"
#include "frames/experiment/reading.h"

namespace kerf {
namespace {

constexpr std::string_view kBsp = "kerf-paper";
constexpr std::string_view kQt = "ode-quadtree";

std::size_t index_of(std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(contestants(), name) - contestants().begin());
}

/// A run in which all take 1 ms to update and 2 to find pairs and leave 100 candidates.
ExperimentRun even_run(std::size_t steps = 60) {
  ExperimentStep row;
  row.moving = 10;
  row.rest = 7;
  row.contestants.assign(contestants().size(), {});
  for (ContestantStep& one : row.contestants) {
    one.update = 1;
    one.collision = 2;
    one.candidates = 100;
    one.height = 3;
    one.leaves = 4;
  }
  ExperimentRun run(steps, row);
  for (std::size_t k = 0; k < steps; ++k) run[k].step = static_cast<std::uint32_t>(k + 1);
  return run;
}

ContestantStep& at(ExperimentRun& run, std::size_t step, std::string_view name) {
  return run[step].contestants[index_of(name)];
}

/// Steps from `begin` to `end` get the value.
template <class Member, class Value>
void set(ExperimentRun& run, std::string_view name, std::size_t begin, std::size_t end, Member member,
         Value value) {
  for (std::size_t k = begin; k < end; ++k) at(run, k, name).*member = value;
}

TEST(RunMeasures, AreNotMovedByAMomentaryDisturbance) {
  ExperimentRun run = even_run();
  at(run, 7, kBsp).collision = 500;
  at(run, 33, kBsp).update = 500;
  EXPECT_EQ(measure(run, kBsp, Measure::collision), 2);
  EXPECT_EQ(measure(run, kBsp, Measure::overhead), 1);
  EXPECT_EQ(measure(run, kBsp, Measure::pairs), 100);
  EXPECT_DOUBLE_EQ(measure(run, kBsp, Measure::frames), 100);
}

TEST(RunMeasures, StepsThatAreNotCountedAreNotZero) {
  ExperimentRun run = even_run();
  for (std::size_t k = 0; k < run.size(); ++k)
    if (k % 5 != 0) at(run, k, kQt).candidates = -1;
  EXPECT_EQ(measure(run, kQt, Measure::pairs), 100);
  set(run, kQt, 0, run.size(), &ContestantStep::candidates, -1);
  EXPECT_TRUE(std::isnan(measure(run, kQt, Measure::pairs)));
  EXPECT_TRUE(std::isnan(measure(run, kQt, Measure::object_pairs_growth)));
}

TEST(RunMeasures, GrowthIsOfTheLastFifthOverTheSecondForEachObject) {
  ExperimentRun run = even_run(100);
  set(run, kBsp, 80, 100, &ContestantStep::collision, 6);
  set(run, kBsp, 20, 40, &ContestantStep::candidates, 50);
  EXPECT_DOUBLE_EQ(measure(run, kBsp, Measure::object_collision_growth), 3);
  EXPECT_DOUBLE_EQ(measure(run, kBsp, Measure::object_pairs_growth), 2);
  for (std::size_t k = 80; k < 100; ++k) run[k].moving = 20;
  EXPECT_DOUBLE_EQ(measure(run, kBsp, Measure::object_collision_growth), 1.5);
  EXPECT_DOUBLE_EQ(measure(run, kBsp, Measure::object_pairs_growth), 1);
}

TEST(RunMeasures, ATreeThatAdaptsHasMorePairsAtFirst) {
  ExperimentRun run = even_run(1000);
  EXPECT_EQ(measure(run, kBsp, Measure::pairs_start), 1);
  set(run, kBsp, 0, 40, &ContestantStep::candidates, 600);
  EXPECT_EQ(measure(run, kBsp, Measure::pairs_start), 6);
  set(run, kBsp, 40, 1000, &ContestantStep::candidates, 900);
  EXPECT_EQ(measure(run, kBsp, Measure::pairs_start), 1) << "what comes later is more";
  set(run, kBsp, 500, 1000, &ContestantStep::candidates, 5);
  EXPECT_EQ(measure(run, kBsp, Measure::pairs_start), 1) << "this is not the start";
}

TEST(RunMeasures, FramesASecondAreOfTheMeanTime) {
  ExperimentRun run = even_run(100);
  for (std::size_t k = 0; k < 20; ++k) run[k].rest = 0;  // a fifth of the steps take 3 ms, the others 10
  EXPECT_DOUBLE_EQ(measure(run, kBsp, Measure::frames), 1000 / 8.6);
}

TEST(RunMeasures, TheMedianOfAnEvenNumberIsBetweenTheMiddleTwo) {
  ExperimentRun run = even_run(4);
  for (std::size_t k = 0; k < 4; ++k) at(run, k, kBsp).candidates = std::array{6458, 564, 1313, 832}[k];
  EXPECT_DOUBLE_EQ(measure(run, kBsp, Measure::pairs), (832 + 1313) / 2.0);
}

TEST(RunMeasures, TheLeadIsOverTheFastestOther) {
  ExperimentRun run = even_run();
  set(run, kBsp, 0, 60, &ContestantStep::collision, 1);  // 9 ms of 10
  set(run, kQt, 0, 60, &ContestantStep::collision, 12);  // 20 ms
  EXPECT_DOUBLE_EQ(measure(run, kBsp, Measure::lead), 10.0 / 9);
  EXPECT_DOUBLE_EQ(measure(run, kQt, Measure::lead), 9.0 / 20);
}

TEST(RunMeasures, SwingsAreOfTheLastTwoThirds) {
  ExperimentRun run = even_run(300);
  set(run, kBsp, 0, 100, &ContestantStep::leaves, 90U);
  EXPECT_EQ(measure(run, kBsp, Measure::leaves_swing), 1);
  set(run, kBsp, 220, 300, &ContestantStep::leaves, 12U);
  EXPECT_EQ(measure(run, kBsp, Measure::leaves_swing), 3);
  set(run, kBsp, 220, 300, &ContestantStep::candidates, 250);
  EXPECT_EQ(measure(run, kBsp, Measure::object_pairs_swing), 2.5);
}

TEST(RunMeasures, ADepthThatJumpsWithinTenSteps) {
  ExperimentRun run = even_run();
  EXPECT_EQ(measure(run, kBsp, Measure::depth_change), 0);
  set(run, kBsp, 50, 60, &ContestantStep::height, 9U);
  EXPECT_EQ(measure(run, kBsp, Measure::depth_change), 6);
}

/// Blocks break after 100 of 200 steps.
ExperimentRun broken_run() {
  ExperimentRun run = even_run(200);
  for (std::size_t k = 100; k < 200; ++k) run[k].moving = 20;
  return run;
}

TEST(RunMeasures, AFractureDividesTheRun) {
  ExperimentRun run = broken_run();
  set(run, kBsp, 0, 100, &ContestantStep::collision, 12);  // 20 ms instead of 10
  set(run, kBsp, 0, 100, &ContestantStep::candidates, 300);
  EXPECT_DOUBLE_EQ(measure(run, kBsp, Measure::frames_before), 50);
  EXPECT_EQ(measure(run, kBsp, Measure::pairs_before), 300);
  EXPECT_DOUBLE_EQ(measure(run, kBsp, Measure::frames_gain), 2);
  EXPECT_DOUBLE_EQ(measure(run, kBsp, Measure::object_pairs_gain), (100.0 / 20) / (300.0 / 10));
}

TEST(RunMeasures, WithoutAFractureThereIsNothingBeforeIt) {
  const ExperimentRun run = even_run();
  for (const Measure of :
       {Measure::frames_before, Measure::pairs_before, Measure::frames_gain, Measure::object_pairs_gain,
        Measure::depth_after_fracture, Measure::depth_settling})
    EXPECT_TRUE(std::isnan(measure(run, kBsp, of)));
}

/// The tree is still being built.
TEST(RunMeasures, AnEarlyFractureHasNoDepthBeforeIt) {
  ExperimentRun run = even_run(1000);
  for (std::size_t k = 38; k < 1000; ++k) run[k].moving = 20;
  for (std::size_t k = 38; k < 138; ++k) at(run, k, kBsp).height = k % 2 == 0 ? 3 : 5;
  EXPECT_TRUE(std::isnan(measure(run, kBsp, Measure::depth_after_fracture)));
  EXPECT_LT(measure(run, kBsp, Measure::depth_settling), 0.01);
}

TEST(RunMeasures, AfterALateFractureTooLittleIsLeft) {
  ExperimentRun run = even_run(100);
  for (std::size_t k = 90; k < 100; ++k) run[k].moving = 20;
  EXPECT_TRUE(std::isnan(measure(run, kBsp, Measure::frames_gain)));
}

TEST(RunMeasures, DepthMovesAfterTheFractureAndSettles) {
  ExperimentRun run = broken_run();
  for (std::size_t k = 105; k < 113; ++k) at(run, k, kBsp).height = k % 2 == 0 ? 3 : 5;
  EXPECT_EQ(measure(run, kBsp, Measure::depth_after_fracture), 17);
  EXPECT_DOUBLE_EQ(measure(run, kBsp, Measure::depth_settling), 1.0 / 17);
}

TEST(RunMeasures, TimesHaveASampleForEachRunAndCountsForEachSeed) {
  std::vector<TimedRun> runs;
  for (const std::uint32_t repeat : {1U, 2U, 3U})
    for (const std::uint64_t seed : {1U, 2U}) runs.push_back({seed, repeat, even_run()});
  EXPECT_EQ(samples_of(runs, kBsp, Measure::collision).size(), 6U);
  EXPECT_EQ(samples_of(runs, kBsp, Measure::pairs).size(), 2U);
}

TEST(RunMeasures, AReadingStandsForTheTree) {
  const std::string_view other = readings().back().contestant;
  ExperimentRun run = even_run();
  set(run, kBsp, 0, run.size(), &ContestantStep::collision, 5);
  set(run, other, 0, run.size(), &ContestantStep::collision, 3);
  set(run, other, 30, 45, &ContestantStep::leaves, 9U);
  ExperimentRuns runs;
  for (auto& simulation : runs) simulation.assign(3, {1, 1, run});
  const Quantity quantity{1, kBsp, Measure::collision};
  EXPECT_EQ(claim_figures(runs, kBsp).at(quantity).front(), 5);
  EXPECT_EQ(claim_figures(runs, other).at(quantity).front(), 3);
  EXPECT_DOUBLE_EQ(measure(run, other, Measure::lead), measure(run, other, Measure::frames) / 100)
      << "its rivals are the paper's, not the tree itself";
  EXPECT_EQ(shape_of(run, other).most_leaves, 9);
  EXPECT_EQ(shape_of(run, other).least_leaves, 4);
  EXPECT_EQ(shape_of(run, kBsp).most_leaves, 4);
}

TEST(RunMeasures, ReadingsDifferFromEachOther) {
  std::set<std::string_view> names;
  std::set<std::string_view> labels;
  for (const Reading& reading : readings()) {
    EXPECT_TRUE(names.insert(reading.contestant).second) << reading.contestant;
    EXPECT_TRUE(labels.insert(reading.label).second) << reading.label;
    EXPECT_EQ(std::ranges::count(contestants(), reading.contestant), 1) << reading.contestant;
  }
  EXPECT_EQ(readings().front().contestant, kBsp);
}

TEST(RunMeasures, ThereAreFiguresOfAllThatIsClaimed) {
  ExperimentRuns runs;
  for (auto& simulation : runs) simulation.assign(3, {1, 1, broken_run()});
  const ClaimFigures figures = claim_figures(runs, kBsp);
  for (const Claim& claim : claims())
    for (const Comparison& comparison : claim.comparisons) {
      ASSERT_TRUE(figures.contains(comparison.subject)) << claim.words;
      EXPECT_EQ(figures.at(comparison.subject).size(), 3U);
      EXPECT_TRUE(!comparison.rival || figures.contains(*comparison.rival)) << claim.words;
    }
}

}  // namespace
}  // namespace kerf
