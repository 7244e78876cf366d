#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>

#include "core/recording/database.h"
#include "frames/support/errors.h"
#include "tests/frames/report/browser.h"
#include "tests/frames/study/study_files.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

namespace fs = std::filesystem;

TEST(StudyProgram, ShardsAreTheWhole) {
  const StudyFolder study;
  const RunOutcome whole = study.run({"-o", "@all"});
  ASSERT_EQ(whole.exit, kExitHolds) << whole.err;
  EXPECT_EQ(whole.err, "") << "no progress where there is no terminal";
  EXPECT_THAT(whole.out, HasSubstr("24 of 24 cells are in"));
  for (const char* const k : {"1", "2", "3"})
    ASSERT_EQ(study.run({"--shard", std::string(k) + "/3", "-o", std::string("@s") + k}).exit, kExitHolds);
  EXPECT_EQ(study.cells("s2").size(), 8U);
  const RunOutcome one = study.run({"--join", "@all", "-o", "@one"});
  const RunOutcome three = study.run({"--join", "@s3", "@s1", "@s2", "-o", "@three"});
  ASSERT_EQ(one.exit, kExitHolds) << one.err;
  ASSERT_EQ(three.exit, kExitHolds) << three.err;
  const std::string table = read_text(study.path("one/cells.csv"));
  EXPECT_EQ(counts_of(table), counts_of(read_text(study.path("three/cells.csv"))));
  EXPECT_EQ(one.out.substr(one.out.find("counts ")), three.out.substr(three.out.find("counts ")));
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 25);
  EXPECT_THAT(table, HasSubstr(",pairs_hash,candidates,"));
  EXPECT_THAT(counts_of(table), Not(HasSubstr("time_")));
}

/// A broad phase that is exact finds the pairs of every other one, and none is missed.
TEST(StudyProgram, TheDatabaseHasTheTable) {
  const StudyFolder study;
  ASSERT_EQ(study.run({"-o", "@all"}).exit, kExitHolds);
  ASSERT_EQ(study.run({"--join", "@all", "-o", "@one"}).exit, kExitHolds);
  const Database database = Database::open(study.path("one/cells.sqlite"));
  EXPECT_EQ(database.ask("SELECT count(*) FROM cells"), 24);
  EXPECT_EQ(database.ask("SELECT count(*) FROM cells WHERE time_total_ms > 0"), 24);
  EXPECT_EQ(database.ask("SELECT count(*) FROM cells WHERE candidates IS NULL"), 16)
      << "only the paper's tree counts them";
  EXPECT_EQ(database.ask("SELECT count(*) FROM (SELECT 1 FROM cells GROUP BY scene, objects, seed "
                         "HAVING count(DISTINCT pairs_hash) > 1)"),
            0);
  EXPECT_EQ(database.ask("SELECT count(DISTINCT pairs_hash) FROM cells"), 8);
  EXPECT_EQ(database.ask("SELECT sum(missed) + sum(extra) FROM cells"), 0);
  EXPECT_GT(database.ask("SELECT min(pairs) FROM cells"), 0);
}

/// The approximate mode misses pairs, and the oracle says so.
TEST(StudyProgram, ErrorsAreCounted) {
  const StudyFolder study(R"({"matrices": [{"motions": ["brownian"], "dimensions": [2], "objects": [60],
    "broad_phases": ["kerf", "kerf:period=4"], "warm_up": 2, "steps": 8, "measure": ["errors"]}]})");
  ASSERT_EQ(study.run({"-o", "@all"}).exit, kExitHolds);
  const auto exact = read_json(study.path("all/" + study.cells("all")[1]));
  const auto late = read_json(study.path("all/" + study.cells("all")[0]));
  ASSERT_EQ(exact["cell"]["broad_phase"], "kerf");
  EXPECT_EQ(exact["counts"]["missed"], 0);
  EXPECT_GT(late["counts"]["missed"], 0);
  EXPECT_TRUE(exact["times"].empty()) << "nothing asked for them";
}

/// Five steps have the pairs of the first two and of the three after these.
TEST(StudyProgram, StepsOfTheWarmUpDoNotCount) {
  const std::string matrix =
      R"("motions": ["brownian"], "dimensions": [2], "objects": [60], "broad_phases": ["kerf"], "warm_up": )";
  const StudyFolder study("{\"matrices\": [{" + matrix + "0, \"steps\": 5}, {" + matrix +
                          "0, \"steps\": 2}, {" + matrix + "2, \"steps\": 3}]}");
  ASSERT_EQ(study.run({"-o", "@all"}).exit, kExitHolds);
  ASSERT_EQ(study.run({"--join", "@all", "-o", "@one"}).exit, kExitHolds);
  const Database database = Database::open(study.path("one/cells.sqlite"));
  EXPECT_EQ(database.ask("SELECT pairs FROM cells WHERE steps = 5"),
            database.ask("SELECT sum(pairs) FROM cells WHERE steps < 5"));
}

/// Scenes with an engine: every broad phase gets the boxes of the same run.
TEST(StudyProgram, ScenesOfBothDimensionsAreMeasured) {
  const StudyFolder study(R"({"matrices": [{"scenes": ["buckets-2d", "pile"], "objects": [30], "grow": 8,
    "broad_phases": ["kerf", "kerf-paper", "sweep-and-prune", "brute-force"], "warm_up": 4, "steps": 6,
    "measure": ["counts", "errors"]}]})");
  ASSERT_EQ(study.run({"-o", "@all"}).exit, kExitHolds);
  ASSERT_EQ(study.run({"--join", "@all", "-o", "@one"}).exit, kExitHolds);
  const Database database = Database::open(study.path("one/cells.sqlite"));
  EXPECT_EQ(database.ask("SELECT count(*) FROM cells"), 8);
  EXPECT_EQ(database.ask("SELECT count(DISTINCT scene || pairs_hash) FROM cells"), 2);
  EXPECT_EQ(database.ask("SELECT sum(missed) + sum(extra) FROM cells"), 0);
}

TEST(StudyProgram, WhatIsThereIsNotMeasuredAgain) {
  const StudyFolder study;
  ASSERT_EQ(study.run({"-o", "@all", "--shard", "1/2"}).exit, kExitHolds);
  const std::string file = "all/" + study.cells("all").front();
  const std::string before = read_text(study.path(file));
  const RunOutcome rest = study.run({"-o", "@all"});
  ASSERT_EQ(rest.exit, kExitHolds);
  EXPECT_THAT(rest.out, HasSubstr("24 of 24 cells are in"));
  EXPECT_THAT(rest.out, HasSubstr("12 of them new"));
  EXPECT_EQ(read_text(study.path(file)), before);
  ASSERT_EQ(study.run({"-o", "@all", "--overwrite"}).exit, kExitHolds);
  EXPECT_NE(read_text(study.path(file)), before) << "times are new";
}

TEST(StudyProgram, AFileOfAnotherKindIsNotReplaced) {
  const StudyFolder study;
  const std::string id = study.run({"--list"}).out.substr(0, study.run({"--list"}).out.find(' '));
  fs::create_directory(study.path("all"));
  study.write("all/" + id + ".json", "{}");
  const RunOutcome refused = study.run({"-o", "@all"});
  EXPECT_EQ(refused.exit, kExitUnusable);
  EXPECT_THAT(refused.err, HasSubstr("exists already"));
  EXPECT_THAT(study.cells("all"), ::testing::SizeIs(1)) << "nothing begins";
  const RunOutcome joined = study.run({"--join", "@all", "-o", "@one"});
  EXPECT_EQ(joined.exit, kExitUnusable);
  EXPECT_THAT(joined.err, HasSubstr("is damaged"));
}

TEST(StudyProgram, OneCellIsReplayedByTheCommandInItsFile) {
  const StudyFolder study;
  ASSERT_EQ(study.run({"-o", "@all", "--shard", "5/24"}).exit, kExitHolds);
  ASSERT_EQ(study.cells("all").size(), 1U);
  const auto kept = read_json(study.path("all/" + study.cells("all")[0]));
  const std::string id = kept["id"];
  EXPECT_EQ(kept["command"], "kerf study " + study.path("study.json") + " --cell " + id);
  const RunOutcome again = study.run({"--cell", id});
  ASSERT_EQ(again.exit, kExitHolds) << again.err;
  const auto printed = nlohmann::json::parse(again.out);
  EXPECT_EQ(printed["counts"], kept["counts"]);
  EXPECT_EQ(printed["cell"], kept["cell"]);
  EXPECT_FALSE(fs::exists("out/study")) << "nothing is kept";
  const RunOutcome unknown = study.run({"--cell", "none"});
  EXPECT_EQ(unknown.exit, kExitUnusable);
  EXPECT_THAT(unknown.err, HasSubstr("--list"));
}

TEST(StudyProgram, TheListSaysWhatIsThere) {
  const StudyFolder study;
  ASSERT_EQ(study.run({"-o", "@all", "--shard", "1/24"}).exit, kExitHolds);
  const RunOutcome some = study.run({"--list", "-o", "@all"});
  EXPECT_EQ(some.exit, kExitDoesNotHold);
  EXPECT_THAT(some.err, HasSubstr("23 of 24 cells are missing"));
  EXPECT_EQ(study.run({"--list", "-o", "@all", "--shard", "1/24"}).exit, kExitHolds);
  const std::string list = some.out;
  EXPECT_EQ(std::count(list.begin(), list.end(), '\n'), 24);
  EXPECT_EQ(list.find("  there\n"), list.find(' ')) << "the first";
  EXPECT_EQ(list.find("  there\n", list.find("  there\n") + 1), std::string::npos);
  const std::string shard = study.run({"--list", "-o", "@all", "--shard", "2/24"}).out;
  EXPECT_EQ(std::count(shard.begin(), shard.end(), '\n'), 1);
}

TEST(StudyProgram, WhatIsMissingIsSaid) {
  const StudyFolder study;
  ASSERT_EQ(study.run({"-o", "@s1", "--shard", "1/2"}).exit, kExitHolds);
  const RunOutcome half = study.run({"--join", "@s1", "-o", "@half"});
  EXPECT_EQ(half.exit, kExitDoesNotHold);
  EXPECT_THAT(half.err, HasSubstr("12 of 24 cells are missing: "));
  EXPECT_THAT(half.err, HasSubstr("and 4 more"));
  EXPECT_THAT(read_text(study.path("half/index.html")), HasSubstr("12 of 24 cells are missing"));
  const std::string table = read_text(study.path("half/cells.csv"));
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 13);
  fs::create_directory(study.path("empty"));
  const RunOutcome nothing = study.run({"--join", "@empty", "-o", "@none"});
  EXPECT_EQ(nothing.exit, kExitDoesNotHold);
  EXPECT_FALSE(fs::exists(study.path("none")));
}

TEST(StudyProgram, DoublesMustHaveTheSameCounts) {
  const StudyFolder study;
  for (const char* const out : {"@a", "@b"}) ASSERT_EQ(study.run({"-o", out}).exit, kExitHolds);
  const RunOutcome twice = study.run({"--join", "@a", "@b", "-o", "@twice"});
  ASSERT_EQ(twice.exit, kExitHolds) << twice.err;
  EXPECT_THAT(twice.out, HasSubstr("24 are there more than once, with equal counts"));
  const std::string file = "b/" + study.cells("b")[3];
  auto cell = read_json(study.path(file));
  cell["counts"]["pairs"] = cell["counts"]["pairs"].get<int>() + 1;
  study.write(file, cell.dump());
  const RunOutcome differ = study.run({"--join", "@a", "@b", "-o", "@differ"});
  EXPECT_EQ(differ.exit, kExitUnusable);
  EXPECT_THAT(differ.err, HasSubstr("different counts"));
  EXPECT_THAT(differ.err, HasSubstr(file));
  EXPECT_FALSE(fs::exists(study.path("differ")));
}

TEST(StudyProgram, FilesOfAnotherStudyAreCountedAndLeftOut) {
  const StudyFolder study;
  ASSERT_EQ(study.run({"-o", "@a"}).exit, kExitHolds);
  std::string longer = StudyFolder::kSmall;
  longer.replace(longer.find("\"steps\": 3"), 10, "\"steps\": 4");
  study.write("study.json", longer);
  ASSERT_EQ(study.run({"-o", "@a", "--shard", "1/24"}).exit, kExitHolds);
  const RunOutcome joined = study.run({"--join", "@a", "-o", "@one"});
  EXPECT_EQ(joined.exit, kExitDoesNotHold);
  EXPECT_THAT(joined.out, HasSubstr("1 of 24 cells"));
  EXPECT_THAT(joined.out, HasSubstr("24 files are of no cell of the study"));
}

TEST(StudyProgram, JoinKeepsItsInputsAndWhatIsThere) {
  const StudyFolder study;
  ASSERT_EQ(study.run({"-o", "@a"}).exit, kExitHolds);
  for (const char* const out : {"@a", "@a/", "@."}) {
    const RunOutcome refused = study.run({"--join", "@a", "-o", out, "--overwrite"});
    EXPECT_EQ(refused.exit, kExitUnusable) << out;
    EXPECT_THAT(refused.err, HasSubstr("which is read")) << out;
  }
  ASSERT_EQ(study.run({"--join", "@a", "-o", "@one"}).exit, kExitHolds);
  const RunOutcome again = study.run({"--join", "@a", "-o", "@one"});
  EXPECT_EQ(again.exit, kExitUnusable);
  EXPECT_THAT(again.err, HasSubstr("--overwrite"));
  EXPECT_EQ(study.run({"--join", "@a", "-o", "@one", "--overwrite"}).exit, kExitHolds);
  EXPECT_EQ(study.run({"--join", "@a"}).exit, kExitUnusable) << "--join needs --out";
}

/// A cell that takes too long ends alone.
TEST(StudyProgram, ACellThatCannotBeMeasuredIsNamed) {
  const StudyFolder study(R"({"matrices": [
    {"motions": ["falling"], "dimensions": [3], "objects": [100000], "steps": 100000, "patience": 1,
     "broad_phases": ["brute-force"]},
    {"motions": ["falling"], "dimensions": [3], "objects": [40], "steps": 3, "broad_phases": ["kerf"]}]})");
  const RunOutcome outcome = study.run({"-o", "@all"});
  EXPECT_EQ(outcome.exit, kExitDoesNotHold);
  EXPECT_THAT(outcome.err, HasSubstr("1 of 2 cells could not be measured"));
  EXPECT_THAT(outcome.err, HasSubstr("brute-force"));
  EXPECT_THAT(outcome.err, HasSubstr("took longer than 1 s"));
  EXPECT_EQ(study.cells("all").size(), 1U);
}

TEST(StudyProgram, AnInterruptLosesNothing) {
  std::string many = StudyFolder::kSmall;
  many.replace(many.find("\"steps\": 3"), 10, "\"steps\": 3, \"repeats\": 200");
  const StudyFolder study(many);
  test::Process process(test::kerf_command(study.arguments({"-o", "@all"})));
  ASSERT_TRUE(test::holds_within_a_minute(
      [&] { return fs::exists(study.path("all")) && study.cells("all").size() >= 3; }));
  process.signal(SIGINT);
  const RunOutcome outcome = process.wait();
  EXPECT_EQ(outcome.exit, kExitInterrupted);
  EXPECT_THAT(outcome.err, HasSubstr("goes on from there"));
  const std::size_t kept = study.cells("all").size();
  EXPECT_THAT(outcome.err, HasSubstr(std::to_string(kept) + " of 4800 cells"));
  EXPECT_EQ(study.cells("all").size(), test::files_in(study.path("all")).size()) << "no part is left";
  const std::string list = study.run({"--list", "-o", "@all"}).out;
  std::size_t there = 0;
  for (std::size_t at = 0; (at = list.find("  there\n", at)) != std::string::npos; ++at) ++there;
  EXPECT_EQ(there, kept) << "each is whole";
}

TEST(StudyProgram, ThePageStandsAloneInABrowser) {
  const StudyFolder study;
  ASSERT_EQ(study.run({"-o", "@all"}).exit, kExitHolds);
  ASSERT_EQ(study.run({"--join", "@all", "-o", "@one"}).exit, kExitHolds);
  const test::Sight sight = test::look_at(study.path("one/index.html"));
  ASSERT_EQ(sight.trouble, "");
  EXPECT_THAT(sight.console, IsEmpty());
  EXPECT_THAT(sight.resources, IsEmpty());
  EXPECT_TRUE(sight.fits);
  EXPECT_EQ(sight.pictures.size(), 2U * 4) << "total, overhead, collision and candidates of two motions";
  for (const auto& picture : sight.pictures) EXPECT_GT(picture.shapes, 5U);
  EXPECT_THAT(read_text(study.path("one/index.html")), HasSubstr("kerf study " + study.path("study.json")));
}

/// A render is a study: its parts are made anywhere, and the joined frames are those of one render.
TEST(StudyProgram, FramesOfARecordingAreCells) {
  const FramesStudy study("2:20:2", "4");
  for (const char* const k : {"1", "2"}) {
    const RunOutcome outcome = study.run({"--shard", std::string(k) + "/2", "-o", std::string("@s") + k});
    ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  }
  const RunOutcome half = study.run({"--join", "@s1", "-o", "@half"});
  EXPECT_EQ(half.exit, kExitDoesNotHold);
  EXPECT_FALSE(fs::exists(study.path("half/run")));
  const RunOutcome joined = study.run({"--join", "@s1", "@s2", "-o", "@one"});
  ASSERT_EQ(joined.exit, kExitHolds) << joined.err;
  ASSERT_EQ(run_kerf({"render", study.path("run.kerf"), "--steps", "2:20:2", "--size", "96x64", "--out",
                      study.path("whole")})
                .exit,
            kExitHolds);
  ASSERT_EQ(test::files_in(study.path("whole")), test::files_in(study.path("one/run")));
  for (const std::string& file : test::files_in(study.path("whole")))
    EXPECT_TRUE(read_text(study.path("whole/" + file)) == read_text(study.path("one/run/" + file))) << file;
}

/// Only the manifests were read, and "all frames" was printed though pictures were damaged.
TEST(StudyProgram, JoinedFramesAreThoseThatWereDrawn) {
  const FramesStudy study("10:40:10", "2");
  ASSERT_EQ(study.run({"-o", "@all"}).exit, kExitHolds);
  const std::string cell = study.cells("all").front();
  const std::string folder = "all/" + fs::path(cell).stem().string() + "/";
  const std::string picture = folder + "run_000002.png";
  const std::string file = fs::exists(study.path(picture)) ? picture : folder + "run_000003.png";
  const std::string other = fs::exists(study.path(picture)) ? "run_000000.png" : "run_000001.png";
  const auto refusal = [&] {
    const RunOutcome outcome = study.run({"--join", "@all", "-o", "@one"});
    EXPECT_EQ(outcome.exit, kExitUnusable) << outcome.out;
    EXPECT_FALSE(fs::exists(study.path("one")));
    return outcome.err;
  };
  const std::string drawn = read_text(study.path(file));
  study.write(file, "garbage");
  EXPECT_THAT(refusal(),
              HasSubstr("cannot be read, " + fs::path(file).filename().string() + "; measure it again"));
  study.write(file, read_text(study.path(folder + other)));
  EXPECT_THAT(refusal(), HasSubstr("has another picture than was drawn"));
  study.write(file, drawn);
  auto json = read_json(study.path("all/" + cell));
  json["counts"]["pixels_hash"] = "0000000000000000";
  study.write("all/" + cell, json.dump());
  EXPECT_THAT(refusal(), HasSubstr("has not the frames that its cell counted; measure it again"));
  json["counts"].erase("pixels_hash");
  study.write("all/" + cell, json.dump());
  EXPECT_THAT(refusal(), HasSubstr(cell + " is damaged"));
}

/// Such files were believed, and the table had no columns of counts.
TEST(StudyProgram, ACellWithoutItsFiguresIsDamaged) {
  const StudyFolder study;
  ASSERT_EQ(study.run({"-o", "@all", "--shard", "1/24"}).exit, kExitHolds);
  const std::string file = "all/" + study.cells("all").front();
  const auto whole = read_json(study.path(file));
  for (const auto& [part, figure] : {std::pair{"counts", "pairs"},
                                     {"counts", "height"},
                                     {"counts", "missed"},
                                     {"times", "total_ms"},
                                     {"times", "overhead_ms"}}) {
    auto json = whole;
    json[part].erase(figure);
    study.write(file, json.dump());
    EXPECT_THAT(study.run({"--join", "@all", "-o", "@one"}).err, HasSubstr("is damaged")) << figure;
    EXPECT_THAT(study.run({"--list", "-o", "@all"}).out, Not(HasSubstr("  there"))) << figure;
  }
}

TEST(StudyProgram, WhatWouldBeIgnoredIsRefused) {
  const StudyFolder study;
  const std::string id = study.run({"--list"}).out.substr(0, study.run({"--list"}).out.find(' '));
  EXPECT_EQ(study.run({"--cell", id, "--shard", "2/2", "-o", "@all"}).exit, kExitUnusable);
  EXPECT_THAT(study.run({"--cell", id, "--overwrite"}).err, HasSubstr("give --out"));
}

/// What an interrupted attempt has drawn is not drawn again.
TEST(StudyProgram, FramesOfAnEarlierAttemptAreKept) {
  const FramesStudy study("2:20:2", "2");
  ASSERT_EQ(study.run({"-o", "@all"}).exit, kExitHolds);
  const std::string cell = study.cells("all").front();
  const std::string counts = read_json(study.path("all/" + cell))["counts"].dump();
  fs::remove(study.path("all/" + cell));
  ASSERT_EQ(study.run({"-o", "@all"}).exit, kExitHolds);
  EXPECT_EQ(read_json(study.path("all/" + cell))["counts"].dump(), counts);
  ASSERT_EQ(study.run({"-o", "@all", "--overwrite"}).exit, kExitHolds);
}

}  // namespace
}  // namespace kerf::test
