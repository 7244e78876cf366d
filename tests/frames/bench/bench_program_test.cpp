#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "frames/bench/ablation.h"
#include "frames/support/errors.h"
#include "tests/frames/program.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

TEST(BenchProgram, PrintsRowsAndWritesJson) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "bench.json").string();
  const RunOutcome outcome =
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
  const RunOutcome outcome = run_kerf({"bench", "--simulations", "terrain,pile-2d", "--objects", "60",
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

TEST(BenchProgram, MeasuresQueriesAndComparesTheirAnswers) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "bench.json").string();
  const RunOutcome outcome = run_kerf({"bench", "--queries", "--scenes", "uniform", "--objects", "300",
                                       "--rounds", "1", "--warm-up", "2", "--json", file});
  ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  const auto rows = read_json(file)["queries"];
  ASSERT_EQ(rows.size(), 26U) << "build, move and eleven kinds, in both dimensions";
  for (const auto& row : rows) {
    EXPECT_EQ(row["structures"][0]["name"], "kerf");
    for (const auto& structure : row["structures"]) {
      EXPECT_GT(structure["least_ns"], 0);
      EXPECT_LE(structure["least_ns"], structure["median_ns"]);
      EXPECT_EQ(structure["differs"], 0) << structure["name"] << " " << row["kind"];
    }
  }
}

TEST(BenchProgram, MeasuresWhatEachPolicyEarnsInASimulation) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "bench.json").string();
  const RunOutcome outcome = run_kerf({"bench", "--ablation", "--simulations", "pile-2d", "--objects", "60",
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
  const RunOutcome outcome = run_kerf({"bench", "--scenes", "uniform", "--dims", "2", "--objects", "200",
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

TEST(BenchProgram, MeasuresRandomScenesAndSaysHowToRepeatThem) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "bench.json").string();
  const std::vector<std::string> usual{"--most",    "200", "--algorithms", "kerf,columns",
                                       "--rounds",  "2",   "--steps",      "5",
                                       "--warm-up", "2",   "--seed",       "9"};
  std::vector<std::string> arguments{"bench", "--random", "3", "--json", file};
  arguments.insert(arguments.end(), usual.begin(), usual.end());
  const RunOutcome outcome = run_kerf(arguments);
  ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  const auto json = read_json(file);
  EXPECT_TRUE(json["complete"]);
  ASSERT_EQ(json["scenes"].size(), 3U);
  for (const auto& scene : json["scenes"]) {
    EXPECT_LE(scene["drawn"]["objects"], 200);
    EXPECT_GT(scene["measured"]["objects"], 0);
    for (const auto& row : scene["results"]) EXPECT_EQ(row["missed"].get<int>() + row["extra"].get<int>(), 0);
  }
  EXPECT_THAT(outcome.out, HasSubstr("geometric mean"));
  EXPECT_THAT(outcome.out, HasSubstr("kerf bench --random 1 --first 2 --seed 9 --most 200"));
  arguments = {"bench", "--random", "1", "--first", "2", "--json", file, "--overwrite"};
  arguments.insert(arguments.end(), usual.begin(), usual.end());
  ASSERT_EQ(run_kerf(arguments).exit, kExitHolds);
  EXPECT_EQ(read_json(file)["scenes"][0]["drawn"], json["scenes"][1]["drawn"]);
}

TEST(BenchProgram, KeepsWhatWasMeasuredWhenInterrupted) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "bench.json";
  const RunOutcome outcome =
      interrupt_kerf({"bench", "--scenes", "uniform,brownian", "--dims", "2", "--objects", "100,2000000",
                      "--algorithms", "kerf", "--rounds", "1", "--json", file.string()},
                     [&] { return has_written_part(file); });
  EXPECT_EQ(outcome.exit, kExitInterrupted) << outcome.err;
  const auto json = read_json(file);
  EXPECT_FALSE(json["complete"]);
  EXPECT_GE(json["results"].size(), 2U);
  EXPECT_EQ(folder.files(), std::vector<std::string>{"bench.json"});
}

TEST(BenchProgram, SaysWhyAFileCannotBeWritten) {
  const RunOutcome outcome =
      run_kerf({"bench", "--scenes", "uniform", "--dims", "2", "--objects", "100", "--algorithms", "kerf",
                "--rounds", "1", "--steps", "2", "--json", "/nowhere/bench.json"});
  EXPECT_EQ(outcome.exit, kExitUnusable);
  EXPECT_THAT(outcome.err, HasSubstr("/nowhere/bench.json"));
  EXPECT_EQ(outcome.out, "") << "it is said before anything is measured";
}

}  // namespace
}  // namespace kerf::test
