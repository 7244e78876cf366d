#include "frames/experiment/claims.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace kerf {
namespace {

std::size_t index_of(std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(contestants(), name) - contestants().begin());
}

/// A run in which all take 1 ms to update and 2 to find pairs and leave 100 candidates.
ExperimentRun even_run() {
  ExperimentStep row;
  row.moving = 10;
  row.rest = 7;
  row.contestants.assign(contestants().size(), {});
  for (ContestantStep& one : row.contestants) {
    one.update = 1;
    one.collision = 2;
    one.candidates = 100;
    one.height = 3;
  }
  return {60, row};
}

ExperimentRuns even_runs() { return {even_run(), even_run(), even_run(), even_run()}; }

bool holds(const ExperimentRuns& runs, int simulation, const char* claim) {
  const std::vector<ClaimVerdict> verdicts = judge_claims(runs);
  const auto found = std::ranges::find_if(verdicts, [&](const ClaimVerdict& v) {
    return v.simulation == simulation && v.claim.starts_with(claim);
  });
  EXPECT_NE(found, verdicts.end()) << claim;
  if (found == verdicts.end()) return false;
  EXPECT_EQ(found->holds, found->reason.empty()) << claim;
  EXPECT_FALSE(found->figures.empty()) << claim;
  return found->holds;
}

void set_collision(ExperimentRun& run, std::string_view name, double milliseconds) {
  for (ExperimentStep& row : run) row.contestants[index_of(name)].collision = milliseconds;
}

TEST(ExperimentMeans, AreNotMovedByAMomentaryDisturbance) {
  ExperimentRun run = even_run();
  run[7].contestants[0].collision = 500;
  run[33].contestants[0].update = 500;
  const Means means = means_of(run, contestants()[0]);
  EXPECT_EQ(means.collision, 2);
  EXPECT_EQ(means.update, 1);
  EXPECT_EQ(means.candidates, 100);
  EXPECT_DOUBLE_EQ(means.fps, 100);
}

TEST(ExperimentMeans, CountAPartOfTheRunAndWhatIsReported) {
  ExperimentRun run = even_run();
  for (std::size_t k = 30; k < 60; ++k) run[k].contestants[2].collision = 8;
  EXPECT_EQ(means_of(run, contestants()[2], 0, 0.5).collision, 2);
  EXPECT_EQ(means_of(run, contestants()[2], 0.5, 1).collision, 8);
  for (ExperimentStep& row : run) row.contestants[1].candidates = -1;
  EXPECT_LT(means_of(run, contestants()[1]).candidates, 0);
}

TEST(ExperimentClaims, AreJudgedByTheFigures) {
  ExperimentRuns runs = even_runs();
  set_collision(runs[1], "ode-quadtree", 1.5);
  EXPECT_TRUE(holds(runs, 2, "QT leads"));
  set_collision(runs[1], "loose-octree", 0.5);
  EXPECT_FALSE(holds(runs, 2, "QT leads"));
  set_collision(runs[3], "ode-hash", 30);
  EXPECT_TRUE(holds(runs, 4, "SH has the worst time"));
  EXPECT_TRUE(holds(runs, 4, "BSP finds the pairs in a much faster way than SH"));
  set_collision(runs[3], "ode-hash", 0.1);
  EXPECT_FALSE(holds(runs, 4, "SH has the worst time"));
  EXPECT_FALSE(holds(runs, 4, "BSP finds the pairs in a much faster way than SH"));
}

TEST(ExperimentClaims, UnknownCandidatesAreNotTheFewest) {
  ExperimentRuns runs = even_runs();
  for (ExperimentStep& row : runs[1]) {
    row.contestants[index_of("sweep-and-prune")].candidates = 50;
    row.contestants[index_of("sweep-and-prune")].update = 9;
    row.contestants[index_of("ode-quadtree")].candidates = -1;
    row.contestants[index_of("ode-hash")].candidates = -1;
  }
  EXPECT_TRUE(holds(runs, 2, "SP generates less pairs"));
  for (ExperimentStep& row : runs[1]) row.contestants[index_of("loose-octree")].candidates = 40;
  EXPECT_FALSE(holds(runs, 2, "SP generates less pairs"));
}

TEST(ExperimentClaims, ADepthThatJumpsIsDramatic) {
  ExperimentRuns runs = even_runs();
  EXPECT_TRUE(holds(runs, 0, "BSP-tree depths"));
  for (std::size_t k = 50; k < 60; ++k) runs[2][k].contestants[index_of("kerf-paper")].height = 9;
  EXPECT_FALSE(holds(runs, 0, "BSP-tree depths"));
}

}  // namespace
}  // namespace kerf
