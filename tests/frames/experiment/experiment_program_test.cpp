#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "frames/support/errors.h"
#include "tests/frames/program.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

constexpr const char* kFirstRun = "simulation-1-terrain-seed-1-repeat-1.csv";

std::vector<std::string> small_experiment(const std::filesystem::path& out, const char* steps = "60",
                                          const char* seeds = "1") {
  return {"experiment", "--steps", steps, "--objects", "60", "--seeds", seeds, "--out", out.string()};
}

std::string all_tables(const std::filesystem::path& folder) {
  std::string all;
  for (const char* name : {"1-terrain", "2-attractors", "3-fracture", "4-buckets"})
    all += test::read_text(folder / ("simulation-" + std::string(name) + "-seed-1-repeat-1.csv"));
  return all;
}

TEST(ExperimentProgram, MakesPagesFiguresAndTablesAndDoesNothingTwice) {
  const TemporaryFolder folder;
  const RunOutcome outcome = run_kerf(small_experiment(folder.path()));
  ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  EXPECT_THAT(folder.files(),
              ::testing::UnorderedElementsAre(
                  "experiment.html", "experiment.md", "figure-12.png", "figure-12.svg", "figure-13.png",
                  "figure-13.svg", kFirstRun, "simulation-2-attractors-seed-1-repeat-1.csv",
                  "simulation-3-fracture-seed-1-repeat-1.csv", "simulation-4-buckets-seed-1-repeat-1.csv"));
  const std::string page = test::read_text(folder.path() / "experiment.md");
  for (const char* word : {"Simulation 4", "ode-quadtree", "too few runs: 1", "figure-13.svg", kFirstRun,
                           "1 repeat of 1 seed", "fewer than", "kerf-paper:swap_share=1"})
    EXPECT_THAT(page, HasSubstr(word));
  const std::string table = test::read_text(folder.path() / kFirstRun);
  EXPECT_EQ(std::ranges::count(table, '\n'), 2 + 60 * 14);
  EXPECT_THAT(test::read_text(folder.path() / "figure-12.svg"), HasSubstr("</svg>"));

  // Times are never the same twice: a table that is the same was not made anew.
  const std::string before = all_tables(folder.path());
  std::filesystem::remove(folder.path() / "simulation-3-fracture-seed-1-repeat-1.csv");
  EXPECT_EQ(run_kerf(small_experiment(folder.path())).exit, kExitUnusable) << "the page is there";
  std::vector<std::string> again = small_experiment(folder.path());
  again.emplace_back("--overwrite");
  ASSERT_EQ(run_kerf(again).exit, kExitHolds);
  EXPECT_EQ(test::read_text(folder.path() / kFirstRun), table);
  EXPECT_NE(all_tables(folder.path()), before);
}

/// The candidates of all broad phases but the tuned tree are counted, ODE's among them.
TEST(ExperimentProgram, RunsSeedsAndRepeatsAndCountsCandidates) {
  const TemporaryFolder folder;
  std::vector<std::string> arguments = small_experiment(folder.path(), "50", "2");
  arguments.insert(arguments.end(), {"--repeats", "2", "--seed", "7"});
  ASSERT_EQ(run_kerf(arguments).exit, kExitHolds);
  const auto run = [&](const char* name) {
    return test::read_text(folder.path() / ("simulation-2-attractors-" + std::string(name) + ".csv"));
  };
  EXPECT_THAT(run("seed-8-repeat-2"), HasSubstr("seed 8, repeat 2"));
  /// The broad phases of a run's eleventh step; in the first repeat the candidates of all but the tuned tree
  /// are there.
  const auto broad_phases = [&](const char* name, bool counted) {
    std::istringstream table(run(name));
    std::size_t count = 0;
    for (std::string line; std::getline(table, line);) {
      std::istringstream cells(line);
      std::vector<std::string> row;
      for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
      if (row.size() < 14 || row[0] != "11") continue;
      EXPECT_EQ(row[5].empty(), !counted || row[2] == "kerf") << line;
      ++count;
    }
    return count;
  };
  EXPECT_EQ(broad_phases("seed-7-repeat-1", true), 14U) << "seven readings are among them";
  EXPECT_EQ(broad_phases("seed-7-repeat-2", false), 7U) << "counts are those of the first repeat";
  EXPECT_THAT(test::read_text(folder.path() / "experiment.md"), HasSubstr("2 repeats of 2 seeds"));
}

/// Each run is made by one shard, and the pages are those of one command.
TEST(ExperimentProgram, ShardsMakeTheRunsOfOneExperiment) {
  const TemporaryFolder folder;
  const std::vector<std::string> whole = small_experiment(folder.path(), "50", "2");
  std::size_t files = 0;
  for (const char* const shard : {"1/3", "2/3", "3/3"}) {
    std::vector<std::string> part = whole;
    part.insert(part.end(), {"--shard", shard});
    const RunOutcome outcome = run_kerf(part);
    ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr(std::string(" of shard ") + shard));
    const std::size_t now = folder.files().size();
    EXPECT_GE(now, files + 2) << "eight runs, two or three for each";
    files = now;
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "experiment.html"));
  }
  EXPECT_EQ(files, 8U);
  const std::string before = all_tables(folder.path());
  ASSERT_EQ(run_kerf(whole).exit, kExitHolds);
  EXPECT_EQ(all_tables(folder.path()), before) << "no run was made anew";
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "experiment.html"));
}

TEST(ExperimentProgram, RefusesAFolderOfAnotherSizeAndDamagedTables) {
  const TemporaryFolder folder;
  std::vector<std::string> first = small_experiment(folder.path());
  first.insert(first.end(), {"--shard", "1/4"});
  ASSERT_EQ(run_kerf(first).exit, kExitHolds);
  const std::string table = test::read_text(folder.path() / kFirstRun);
  std::ofstream(folder.path() / kFirstRun) << table.substr(0, table.find('\n')) << "\nstep\n1,2,3\n";
  const RunOutcome other = run_kerf(small_experiment(folder.path(), "70"));
  EXPECT_EQ(other.exit, kExitUnusable);
  EXPECT_THAT(other.err, HasSubstr("another experiment"));
  const RunOutcome damaged = run_kerf(small_experiment(folder.path()));
  EXPECT_EQ(damaged.exit, kExitUnusable);
  EXPECT_THAT(damaged.err, HasSubstr("remove it"));
}

TEST(ExperimentProgram, RefusesTheFileOfAnEarlierKerf) {
  const TemporaryFolder folder;
  const std::filesystem::path earlier = folder.path() / "simulation-2-attractors.csv";
  std::ofstream(earlier) << "# kerf experiment, simulation 2 (attractors), steps 60, objects 60, seed 1\n";
  const RunOutcome outcome = run_kerf(small_experiment(folder.path()));
  EXPECT_EQ(outcome.exit, kExitUnusable);
  EXPECT_THAT(outcome.err, HasSubstr("earlier kerf"));
  EXPECT_THAT(outcome.err, HasSubstr("--out"));
  EXPECT_EQ(std::ranges::distance(std::filesystem::directory_iterator(folder.path())), 1);
}

TEST(ExperimentProgram, KeepsWhatIsDoneWhenInterrupted) {
  const TemporaryFolder folder;
  const std::filesystem::path first = folder.path() / kFirstRun;
  const RunOutcome outcome = test::interrupt_kerf(small_experiment(folder.path(), "2000"),
                                                  [&] { return std::filesystem::exists(first); });
  EXPECT_EQ(outcome.exit, kExitInterrupted) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("of 4 runs are in"));
  EXPECT_THAT(outcome.err, HasSubstr("the same command goes on"));
  EXPECT_TRUE(std::filesystem::exists(first));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "experiment.md"));
}

TEST(ExperimentProgram, MistakesAreExplained) {
  const RunOutcome few = run_kerf({"experiment", "--steps", "3"});
  EXPECT_EQ(few.exit, kExitUnusable);
  EXPECT_THAT(few.err, HasSubstr("--steps '3'"));
  const RunOutcome both = run_kerf({"experiment", "--full", "--steps", "100"});
  EXPECT_EQ(both.exit, kExitUnusable);
  EXPECT_THAT(both.err, HasSubstr("--full"));
  const RunOutcome none = run_kerf({"experiment", "--repeats", "0"});
  EXPECT_EQ(none.exit, kExitUnusable);
  EXPECT_THAT(none.err, HasSubstr("--repeats '0'"));
}

}  // namespace
}  // namespace kerf::test
