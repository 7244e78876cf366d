#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <thread>

#include "core/files/part_file.h"
#include "frames/bench/ablation.h"
#include "frames/support/errors.h"
#include "tests/frames/program.h"

namespace kerf {
namespace {

using ::testing::HasSubstr;
using testing::kerf_command;
using testing::Outcome;
using testing::Process;
using testing::read_json;
using testing::run_kerf;
using testing::TemporaryFolder;

TEST(BenchProgram, PrintsRowsAndWritesJson) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "bench.json").string();
  const Outcome outcome =
      run_kerf({"bench", "--scenes", "falling,needles", "--objects", "200", "--algorithms", "kerf,box2d-tree",
                "--rounds", "1", "--steps", "5", "--warm-up", "3", "--json", file});
  EXPECT_EQ(outcome.exit, kExitHolds) << outcome.err;
  EXPECT_EQ(outcome.err, "") << "no progress where there is no terminal";
  EXPECT_THAT(outcome.out, HasSubstr("box2d-tree"));
  const auto json = read_json(file);
  EXPECT_TRUE(json["complete"]);
  EXPECT_TRUE(json["machine"].contains("processor"));
  // Per scene: floor and tree in each dimension, Box2D in one.
  ASSERT_EQ(json["results"].size(), 10U);
  for (const auto& row : json["results"]) {
    for (const char* key : {"scene", "dim", "objects", "algorithm", "threads", "median_ns", "p90_ns",
                            "p99_ns", "native_ns", "pairs", "missed", "extra", "times_floor", "rss_bytes"})
      EXPECT_TRUE(row.contains(key)) << key;
    EXPECT_EQ(row["missed"], 0);
    EXPECT_EQ(row["extra"], 0);
    EXPECT_GT(row["median_ns"], 0);
  }
}

TEST(BenchProgram, MeasuresBroadPhasesInTheLoopOfASimulation) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "bench.json").string();
  const Outcome outcome = run_kerf({"bench", "--simulations", "terrain,pile-2d", "--objects", "60",
                                    "--algorithms", "kerf,kerf-paper,sort-and-sweep", "--rounds", "2",
                                    "--steps", "20", "--warm-up", "10", "--json", file});
  ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  EXPECT_EQ(outcome.err, "") << "no progress where there is no terminal";
  const auto json = read_json(file);
  EXPECT_TRUE(json["complete"]);
  EXPECT_EQ(json["results"].size(), 0U);
  ASSERT_EQ(json["simulations"].size(), 6U);
  for (const auto& row : json["simulations"]) {
    EXPECT_GE(row["objects"], 60) << "the scene has grown before it is measured";
    EXPECT_EQ(row["steps"], 20);
    EXPECT_GT(row["loop_ns"], 0);
    EXPECT_GT(row["alone_ns"], 0);
    EXPECT_GT(row["share"], 0);
    EXPECT_LT(row["share"], 1) << "the narrow phase and the solver take the rest";
  }
  EXPECT_EQ(json["simulations"][5]["dim"], 2);
  EXPECT_THAT(outcome.out, HasSubstr("sort-and-sweep"));
}

TEST(BenchProgram, MeasuresWhatEachPolicyEarnsInASimulation) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "bench.json").string();
  const Outcome outcome = run_kerf({"bench", "--ablation", "--simulations", "pile-2d", "--objects", "60",
                                    "--rounds", "3", "--steps", "20", "--warm-up", "10", "--json", file});
  ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  const auto json = read_json(file);
  const std::size_t policies = ablated_policies().size();
  ASSERT_EQ(json["simulations"].size(), 1U) << "only the tuned tree stands in the loop";
  ASSERT_EQ(json["results"].size(), policies + 1) << "the others get the same boxes";
  for (const auto& row : json["results"]) {
    EXPECT_EQ(row["round_ns"].size(), 3U);
    EXPECT_EQ(row["objects"], json["simulations"][0]["objects"]);
    EXPECT_EQ(row["pairs"], json["results"][0]["pairs"]);
    EXPECT_GT(row["median_ns"], 0);
  }
  ASSERT_EQ(json["earnings"].size(), policies);
  for (const auto& earning : json["earnings"]) EXPECT_LT(earning["least"], earning["most"]);
  EXPECT_THAT(outcome.out, HasSubstr("EACH POLICY WHERE IT EARNS MOST"));
}

TEST(BenchProgram, MeasuresWhatAnApproximateTreeMissesAndInvents) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "bench.json").string();
  const Outcome outcome = run_kerf({"bench", "--scenes", "uniform", "--dims", "2", "--objects", "200",
                                    "--algorithms", "kerf,kerf:period=4:schedule_interval=5,kerf:grid=0.5",
                                    "--rounds", "1", "--steps", "8", "--warm-up", "3", "--json", file});
  ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  const auto rows = read_json(file)["results"];
  ASSERT_EQ(rows.size(), 4U) << "the floor is first";
  EXPECT_EQ(rows[1]["missed"], 0);
  EXPECT_GT(rows[2]["missed"], 0);
  EXPECT_GT(rows[2]["extra"], 0);
  EXPECT_EQ(rows[3]["missed"], 0) << "rounding is monotone";
  EXPECT_GT(rows[3]["extra"], 0);
}

TEST(BenchProgram, KeepsWhatWasMeasuredWhenInterrupted) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "bench.json";
  Process process(
      kerf_command({"bench", "--scenes", "uniform,brownian", "--dims", "2", "--objects", "100,2000000",
                    "--algorithms", "kerf", "--rounds", "1", "--json", file.string()}));
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  const auto is_saved = [&] {
    const auto parts = parts_of(file);
    std::error_code none;
    return !parts.empty() && std::filesystem::file_size(parts.front(), none) > 0 && !none;
  };
  while (!is_saved() && std::chrono::steady_clock::now() < give_up)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  process.signal(SIGINT);
  const Outcome outcome = process.wait();
  EXPECT_EQ(outcome.exit, kExitInterrupted) << outcome.err;
  const auto json = read_json(file);
  EXPECT_FALSE(json["complete"]);
  EXPECT_GE(json["results"].size(), 2U);
  EXPECT_EQ(folder.files(), std::vector<std::string>{"bench.json"});
}

TEST(BenchProgram, SaysWhyAFileCannotBeWritten) {
  const Outcome outcome =
      run_kerf({"bench", "--scenes", "uniform", "--dims", "2", "--objects", "100", "--algorithms", "kerf",
                "--rounds", "1", "--steps", "2", "--json", "/nowhere/bench.json"});
  EXPECT_EQ(outcome.exit, kExitUnusable);
  EXPECT_THAT(outcome.err, HasSubstr("/nowhere/bench.json"));
  EXPECT_EQ(outcome.out, "") << "it is said before anything is measured";
}

struct Mistake {
  const char* name;
  std::vector<std::string> arguments;
  const char* answer;
};

void PrintTo(const Mistake& mistake, std::ostream* stream) { *stream << mistake.name; }

class BenchMistake : public ::testing::TestWithParam<Mistake> {};

TEST_P(BenchMistake, IsExplained) {
  std::vector<std::string> arguments = GetParam().arguments;
  arguments.insert(arguments.begin(), "bench");
  const Outcome outcome = run_kerf(arguments);
  EXPECT_EQ(outcome.exit, kExitUnusable) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr(GetParam().answer));
  EXPECT_THAT(outcome.err, HasSubstr("--help"));
  EXPECT_EQ(outcome.out, "");
}

INSTANTIATE_TEST_SUITE_P(
    BenchProgram, BenchMistake,
    ::testing::Values(
        Mistake{"Scene", {"--scenes", "bronian"}, "did you mean 'brownian'?"},
        Mistake{"Algorithm", {"--algorithms", "colums"}, "did you mean 'columns'?"},
        Mistake{"Parameter", {"--algorithms", "kerf:max_hight=3"}, "did you mean 'max_height'?"},
        Mistake{"Period", {"--algorithms", "kerf:period=0"}, "from 1 to 1000000"},
        Mistake{"Shrink", {"--algorithms", "kerf:shrink=1"}, "it needs a grid"},
        Mistake{"Simulation", {"--simulations", "terain"}, "did you mean 'terrain'?"},
        Mistake{"SimulationAndScene", {"--simulations", "pile", "--scenes", "flat"}, "leave one"},
        Mistake{"AblationOfAlgorithms", {"--ablation", "--algorithms", "kerf"}, "leave --algorithms out"},
        Mistake{"InLoop", {"--simulations", "pile-2d", "--algorithms", "colums"}, "2D broad phase"},
        Mistake{"Dimension", {"--dims", "4"}, "from 2 to 3"},
        Mistake{"Objects", {"--objects", "1"}, "whole number from"},
        Mistake{"EmptyName", {"--objects", "1000,,2000"}, "between commas"},
        Mistake{"Rounds", {"--rounds", "0"}, "whole number from 1"},
        Mistake{"Option", {"--scnes", "brownian"}, "did you mean '--scenes'?"}),
    [](const ::testing::TestParamInfo<Mistake>& mistake) { return std::string(mistake.param.name); });

}  // namespace
}  // namespace kerf
