// What the paper says of the related work, judged by figures, and the page of a run.
#include "frames/experiment/related.h"

#include <gmock/gmock.h>

#include "frames/support/errors.h"
#include "tests/frames/program.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

constexpr RelatedClaim kSlower{"words", RelatedMeasure::update, "kinetic-tree", "kerf-paper", true, 1.5};

/// All of them take `usual` milliseconds an update, the kinetic tree `other`.
RelatedRun run_of(double usual, double other) {
  RelatedRun run;
  for (const std::string_view name : related_contestants()) {
    std::array<RelatedFigures, kRelatedParts> parts;
    parts.fill({100, name == "kinetic-tree" ? other : usual, 1});
    run.parts.push_back(parts);
    run.wrong.push_back(0);
  }
  return run;
}

RelatedRuns runs_of(std::array<double, 4> others) {
  RelatedRuns runs;
  for (std::size_t k = 0; k < 4; ++k) runs[k].assign(3, run_of(2, others[k]));
  return runs;
}

TEST(RelatedVerdict, HoldsInAllSimulationsPartlyInSomeOrNot) {
  EXPECT_EQ(judge(kSlower, runs_of({4, 4, 4, 8})).outcome, Outcome::holds);
  EXPECT_EQ(judge(kSlower, runs_of({4, 4, 4, 8})).figures, "2, 2, 2, 4 times");
  EXPECT_EQ(judge(kSlower, runs_of({4, 2.9, 4, 8})).outcome, Outcome::partly);
  EXPECT_EQ(judge(kSlower, runs_of({2.8, 2.8, 1, 1})).outcome, Outcome::partly) << "in kind, not in degree";
  EXPECT_EQ(judge(kSlower, runs_of({2, 2, 1, 1})).outcome, Outcome::opposite);
  RelatedClaim faster = kSlower;
  faster.more = false;
  EXPECT_EQ(judge(faster, runs_of({1, 1, 1, 1})).outcome, Outcome::holds);
  EXPECT_EQ(judge(faster, runs_of({1, 1.5, 1, 1})).outcome, Outcome::partly);
}

TEST(RelatedVerdict, ARunThatDiffersIsNotOverlooked) {
  RelatedRuns runs = runs_of({4, 4, 4, 4});
  runs[0] = {run_of(2, 4), run_of(2, 0.1), run_of(2, 5)};
  EXPECT_EQ(judge(kSlower, runs).outcome, Outcome::partly);
}

TEST(RelatedVerdict, WhatWasNotMeasuredIsNotJudged) {
  RelatedRuns two;
  for (auto& runs : two) runs.assign(2, run_of(2, 4));
  EXPECT_EQ(judge(kSlower, two).outcome, Outcome::cannot_be_judged) << "too few runs";
  EXPECT_EQ(judge(kSlower, {}).outcome, Outcome::cannot_be_judged);
  for (const RelatedClaim& claim : related_claims()) {
    const bool is_judged = claim.measure != RelatedMeasure::none;
    EXPECT_EQ(judge(claim, runs_of({4, 4, 4, 4})).outcome != Outcome::cannot_be_judged, is_judged)
        << claim.words;
    EXPECT_FALSE(claim.note.empty()) << claim.words;
  }
}

TEST(RelatedRun, HasTheMeansOfItsTenths) {
  ExperimentRun run(20);
  for (std::size_t k = 0; k < run.size(); ++k) {
    run[k].contestants.resize(1);
    run[k].contestants[0] = {
        .update = static_cast<double>(k), .collision = 1, .wrong = 1, .candidates = k % 2 == 0 ? 50.0 : -1.0};
  }
  const RelatedRun summary = summarise(run);
  EXPECT_EQ(summary.parts[0][0].update, 0.5);
  EXPECT_EQ(summary.parts[0][9].update, 18.5);
  EXPECT_EQ(summary.parts[0][9].candidates, 50) << "of the steps in which they were counted";
  EXPECT_EQ(summary.wrong[0], 20U);
}

TEST(RelatedProgram, WritesAPageOnWhichNoPairIsWrong) {
  const TemporaryFolder folder;
  const std::filesystem::path out = folder.path() / "related";
  const RunOutcome outcome =
      run_kerf({"experiment", "--related", "--steps", "60", "--objects", "60", "--seeds", "1", "--out", out});
  ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  const std::string page = read_text(out / "related.html");
  for (const std::string_view name : related_contestants()) EXPECT_THAT(page, HasSubstr(std::string(name)));
  EXPECT_THAT(page,
              HasSubstr("kerf experiment --related --steps 60 --objects 60 --seed 1 --seeds 1 --repeats 1"));
  const RunOutcome again =
      run_kerf({"experiment", "--related", "--steps", "60", "--objects", "60", "--seeds", "1", "--out", out});
  EXPECT_EQ(again.exit, kExitUnusable) << "an earlier page is kept";
}

TEST(RelatedProgram, ItsRunsAreSharedAndGoOnFromWhereTheyWere) {
  const TemporaryFolder folder;
  std::vector<std::string> whole{"experiment", "--related", "--steps", "50",
                                 "--objects",  "50",        "--seeds", "1",
                                 "--repeats",  "2",         "--out",   folder.path().string()};
  std::vector<std::string> part = whole;
  part.insert(part.end(), {"--shard", "2/2"});
  const RunOutcome outcome = run_kerf(part);
  ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  EXPECT_EQ(folder.files().size(), 4U) << "half of two repeats of four simulations";
  const std::filesystem::path made = folder.path() / "related-simulation-1-terrain-seed-1-repeat-2.csv";
  const std::string before = read_text(made);
  EXPECT_THAT(before, HasSubstr("self-organising-tree"));
  ASSERT_EQ(run_kerf(whole).exit, kExitHolds);
  EXPECT_EQ(folder.files().size(), 9U);
  EXPECT_EQ(read_text(made), before) << "no run was made anew";
  EXPECT_THAT(read_text(folder.path() / "related.html"), HasSubstr("2 repeats of 1 seed"));
}

}  // namespace
}  // namespace kerf::test
