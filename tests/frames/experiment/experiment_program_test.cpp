#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "frames/support/errors.h"
#include "tests/frames/program.h"

namespace kerf {
namespace {

using ::testing::HasSubstr;
using testing::Outcome;
using testing::run_kerf;
using testing::TemporaryFolder;

std::vector<std::string> small_experiment(const std::filesystem::path& out, const char* steps = "60") {
  return {"experiment", "--steps", steps, "--objects", "60", "--out", out.string()};
}

std::string all_tables(const std::filesystem::path& folder) {
  std::string all;
  for (const char* name : {"1-terrain", "2-attractors", "3-fracture", "4-buckets"})
    all += testing::read_text(folder / ("simulation-" + std::string(name) + ".csv"));
  return all;
}

TEST(ExperimentProgram, MakesPageFiguresAndTablesAndDoesNothingTwice) {
  const TemporaryFolder folder;
  const Outcome outcome = run_kerf(small_experiment(folder.path()));
  ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  EXPECT_THAT(folder.files(), ::testing::UnorderedElementsAre(
                                  "experiment.md", "figure-12.png", "figure-12.svg", "figure-13.png",
                                  "figure-13.svg", "simulation-1-terrain.csv", "simulation-2-attractors.csv",
                                  "simulation-3-fracture.csv", "simulation-4-buckets.csv"));
  const std::string page = testing::read_text(folder.path() / "experiment.md");
  for (const char* word :
       {"Simulation 4", "ode-quadtree", "holds", "figure-13.svg", "simulation-2-attractors.csv"})
    EXPECT_THAT(page, HasSubstr(word));
  const std::string table = testing::read_text(folder.path() / "simulation-1-terrain.csv");
  EXPECT_EQ(std::ranges::count(table, '\n'), 2 + 60 * 7);
  EXPECT_THAT(testing::read_text(folder.path() / "figure-12.svg"), HasSubstr("</svg>"));

  // Times are never the same twice: a table that is the same was not made anew.
  const std::string before = all_tables(folder.path());
  std::filesystem::remove(folder.path() / "simulation-3-fracture.csv");
  EXPECT_EQ(run_kerf(small_experiment(folder.path())).exit, kExitUnusable) << "the page is there";
  std::vector<std::string> again = small_experiment(folder.path());
  again.emplace_back("--overwrite");
  ASSERT_EQ(run_kerf(again).exit, kExitHolds);
  EXPECT_EQ(testing::read_text(folder.path() / "simulation-1-terrain.csv"), table);
  EXPECT_NE(all_tables(folder.path()), before);
}

TEST(ExperimentProgram, RefusesAFolderOfAnotherSizeAndDamagedTables) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "simulation-2-attractors.csv")
      << "# kerf experiment, simulation 2 (attractors), steps 60, objects 60, seed 1\nstep\n1,2,3\n";
  const Outcome other = run_kerf(small_experiment(folder.path(), "70"));
  EXPECT_EQ(other.exit, kExitUnusable);
  EXPECT_THAT(other.err, HasSubstr("another experiment"));
  const Outcome damaged = run_kerf(small_experiment(folder.path()));
  EXPECT_EQ(damaged.exit, kExitUnusable);
  EXPECT_THAT(damaged.err, HasSubstr("remove it"));
}

TEST(ExperimentProgram, KeepsWhatIsDoneWhenInterrupted) {
  const TemporaryFolder folder;
  const std::filesystem::path first = folder.path() / "simulation-1-terrain.csv";
  const Outcome outcome = testing::interrupt_kerf(small_experiment(folder.path(), "2000"),
                                                  [&] { return std::filesystem::exists(first); });
  EXPECT_EQ(outcome.exit, kExitInterrupted) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("the same command goes on"));
  EXPECT_TRUE(std::filesystem::exists(first));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "experiment.md"));
}

TEST(ExperimentProgram, MistakesAreExplained) {
  const Outcome few = run_kerf({"experiment", "--steps", "3"});
  EXPECT_EQ(few.exit, kExitUnusable);
  EXPECT_THAT(few.err, HasSubstr("--steps '3'"));
  const Outcome both = run_kerf({"experiment", "--full", "--steps", "100"});
  EXPECT_EQ(both.exit, kExitUnusable);
  EXPECT_THAT(both.err, HasSubstr("--full"));
}

}  // namespace
}  // namespace kerf
