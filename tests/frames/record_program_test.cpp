#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>

#include "core/files/part_file.h"
#include "core/recording/recording_reader.h"
#include "frames/sequence/recording_file.h"
#include "tests/frames/program.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

TEST(RecordProgram, RecordsAndVerifiesScenesOfBothDimensions) {
  for (const char* const scene : {"pile", "terrain"}) {
    const TemporaryFolder folder;
    const std::string file = folder.path() / "a.kerf";
    const RunOutcome recorded = run_kerf({"record", scene, "-o", file, "--steps", "40", "--objects", "60",
                                          "--grow", "20", "--config", "min_threshold=4,max_threshold=8"});
    ASSERT_EQ(recorded.exit, 0) << recorded.err;
    EXPECT_THAT(recorded.out, HasSubstr("40 steps"));
    EXPECT_EQ(folder.files(), std::vector<std::string>{"a.kerf"});
    const RunOutcome verified = run_kerf({"verify", file, "--timings"});
    EXPECT_EQ(verified.exit, 0) << verified.err;
    EXPECT_THAT(verified.out,
                HasSubstr("every event, figure, state hash, keyframe and set of pairs is as recorded"));
    EXPECT_THAT(verified.out, HasSubstr("oracle: 0 missed, 0 extra, 0 twice"));
    EXPECT_THAT(verified.out, HasSubstr("one step back: median"));
  }
}

TEST(RecordProgram, RenderingRecordsTheSameRun) {
  const TemporaryFolder folder;
  const std::string alone = folder.path() / "alone.kerf";
  const std::string beside = folder.path() / "beside.kerf";
  const std::vector<std::string> scene{"--objects", "40", "--grow", "20", "--seed", "3"};
  std::vector<std::string> record{"record", "pile", "-o", alone, "--steps", "30"};
  std::vector<std::string> render{"render",  "pile",   "--record", beside,  "--steps",
                                  "1:30:10", "--size", "160x120",  "--out", folder.path() / "frames"};
  record.insert(record.end(), scene.begin(), scene.end());
  render.insert(render.end(), scene.begin(), scene.end());
  ASSERT_EQ(run_kerf(record).exit, 0);
  const RunOutcome rendered = run_kerf(render);
  ASSERT_EQ(rendered.exit, 0) << rendered.err;
  const RecordingReader<2> one(alone);
  const RecordingReader<2> other(beside);
  ASSERT_EQ(one.steps(), 30U);
  ASSERT_EQ(other.steps(), 30U);
  EXPECT_TRUE(other.info().complete);
  for (std::uint32_t step = 1; step <= 30; ++step)
    EXPECT_EQ(one.row(step).state_hash, other.row(step).state_hash) << "in step " << step;
}

/// Pictures and manifests of a recording say which tree was recorded.
TEST(RecordProgram, TheBroadPhaseIsTheRecordedOne) {
  for (const std::string name : {"kerf-paper", "kerf"}) {
    const TemporaryFolder folder;
    const std::string file = folder.path() / "a.kerf";
    const RunOutcome recorded = run_kerf({"record", "pile", "-o", file, "--steps", "3", "--objects", "20",
                                          "--broad-phase", name, "--config", "max_redundancy=0.1"});
    ASSERT_EQ(recorded.exit, 0) << recorded.err;
    EXPECT_EQ(broad_phase_of(RecordingReader<2>(file).info()), name);
    const RunOutcome rendered =
        run_kerf({"render", file, "--steps", "3", "--size", "160x120", "--out", folder.path() / "frames"});
    ASSERT_EQ(rendered.exit, 0) << rendered.err;
    const auto manifest = test::read_json(folder.path() / "frames/frames.json");
    EXPECT_EQ(manifest["broad_phase"], name);
    EXPECT_NEAR(manifest["config"]["max_redundancy"].get<double>(), 0.1, 1e-6);
    EXPECT_FALSE(manifest["frames"][0].contains("contacts")) << "a recording holds none";
  }
}

TEST(RecordProgram, ReplacesRecordingsOnlyWhenAskedAndNothingElseEver) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "a.kerf";
  const std::vector<std::string> command{"record", "pile", "-o", file, "--steps", "2"};
  std::vector<std::string> forced = command;
  forced.emplace_back("--overwrite");
  EXPECT_EQ(run_kerf(command).exit, 0);
  const RunOutcome refused = run_kerf(command);
  EXPECT_EQ(refused.exit, 2);
  EXPECT_THAT(refused.err, HasSubstr("replace it with --overwrite"));
  EXPECT_EQ(run_kerf(forced).exit, 0);
  constexpr int kVersionPlace = 63;  // last byte of SQLite's user version
  std::fstream(file, std::ios::in | std::ios::out | std::ios::binary).seekp(kVersionPlace).put(1);
  EXPECT_THAT(run_kerf({"verify", file}).err, HasSubstr("version 1"));
  EXPECT_EQ(run_kerf(forced).exit, 0) << "what an older Kerf has recorded";
  std::ofstream(file) << "a letter";
  const RunOutcome protected_file = run_kerf(forced);
  EXPECT_EQ(protected_file.exit, 2);
  EXPECT_THAT(protected_file.err, HasSubstr("is no recording"));
  EXPECT_EQ(test::read_text(file), "a letter");
}

TEST(RecordProgram, InterruptedOrKilledItLeavesWhatWasDone) {
  for (const int signal : {SIGINT, SIGHUP, SIGKILL}) {
    const TemporaryFolder folder;
    const std::string file = folder.path() / "a.kerf";
    Process process(kerf_command({"record", "pile", "-o", file, "--steps", "900000", "--objects", "30"}));
    const auto enough = [&] {
      const auto parts = parts_of(file);
      if (parts.empty()) return false;
      std::error_code none;
      const auto size = std::filesystem::file_size(parts.front().string() + "-wal", none);
      return !none && size > 200'000;
    };
    ASSERT_TRUE(holds_within_a_minute(enough));
    EXPECT_EQ(run_kerf({"lint", file}).exit, 0) << "while it is being written";
    process.signal(signal);
    EXPECT_EQ(process.wait().exit, signal == SIGKILL ? 128 + SIGKILL : 130);
    const RunOutcome verified = run_kerf({"verify", file, "--oracle-every", "0"});
    EXPECT_EQ(verified.exit, 0) << verified.err;
    EXPECT_EQ(RecordingReader<2>(file).info().complete, signal != SIGKILL);
    EXPECT_GT(RecordingReader<2>(file).steps(), 10U);
    EXPECT_EQ(parts_of(file).size(), signal == SIGKILL ? 1U : 0U);
  }
}

TEST(RecordProgram, BadInputIsNamed) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "a.kerf";
  EXPECT_THAT(run_kerf({"record", "pile", "-o", file, "--steps", "1:10:2"}).err, HasSubstr("every step"));
  EXPECT_THAT(run_kerf({"record", "pil", "-o", file}).err, HasSubstr("did you mean 'pile'"));
  EXPECT_EQ(run_kerf({"record", "pile"}).exit, 2);
  const RunOutcome missing = run_kerf({"verify", file});
  EXPECT_EQ(missing.exit, 2);
  EXPECT_THAT(missing.err, HasSubstr("there is no recording"));
  const RunOutcome nowhere = run_kerf({"record", "pile", "-o", folder.path() / "no/folder/a.kerf"});
  EXPECT_EQ(nowhere.exit, 2);
  EXPECT_THAT(nowhere.err, HasSubstr("No such file or directory"));
}

}  // namespace
}  // namespace kerf::test
