#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "frames/support/errors.h"
#include "tests/frames/program.h"
#include "viz/image/png.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

using Arguments = std::vector<std::string>;

/// A sequence is replaced in a folder of its own, within the earlier one's.
bool has_begun_apart(const std::filesystem::path& folder) {
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.is_directory() && std::filesystem::exists(entry.path() / "pile_000003.png")) return true;
  return false;
}

/// What an interrupt says is what one can do.
TEST(InterruptedProgram, TheSameCommandWithResumeReplacesTheEarlierSequenceAndFilm) {
  const TemporaryFolder folder;
  const auto out = folder.path() / "frames";
  const auto film = folder.path() / "film.mp4";
  const Arguments replaces{"--overwrite", "--video", film};
  ASSERT_EQ(run_kerf(with(short_render(out, "1:41:10"), replaces)).exit, kExitHolds);
  const std::string picture = test::read_text(out / "pile_000001.png");
  const std::string earlier_film = test::read_text(film);
  const Arguments arguments = with(with(short_render(out, "1:1000:10"), replaces), {"--seed", "2"});
  const RunOutcome outcome = interrupt_kerf(arguments, [&] { return has_begun_apart(out); });
  EXPECT_EQ(outcome.exit, kExitInterrupted);
  EXPECT_THAT(outcome.err,
              HasSubstr("the earlier sequence is as it was; the same command with --resume makes"));
  EXPECT_TRUE(test::read_text(out / "pile_000001.png") == picture);
  EXPECT_TRUE(test::read_text(film) == earlier_film);

  const RunOutcome other = run_kerf(with(arguments, {"--resume", "--camera", "width=9"}));
  EXPECT_EQ(other.exit, kExitUnusable) << "it is the rest of neither sequence";
  const RunOutcome resumed = run_kerf(with(arguments, {"--resume"}));
  ASSERT_EQ(resumed.exit, kExitHolds) << resumed.err;
  EXPECT_FALSE(test::read_text(film) == earlier_film);
  const auto whole = folder.path() / "whole";
  ASSERT_EQ(run_kerf(with(short_render(whole, "1:1000:10"), {"--seed", "2"})).exit, kExitHolds);
  ASSERT_EQ(test::files_in(out), test::files_in(whole));
  for (const std::string& file : test::files_in(whole))
    EXPECT_TRUE(test::read_text(out / file) == test::read_text(whole / file)) << file;
}

TEST(InterruptedProgram, ARenderThatRecordsIsResumedWithoutTheRecording) {
  const TemporaryFolder folder;
  const Arguments arguments = short_render(folder.path() / "frames", "1:1000:10");
  const RunOutcome outcome = interrupt_kerf(with(arguments, {"--record", folder.path() / "run.kerf"}), [&] {
    return std::filesystem::exists(folder.path() / "frames" / "pile_000003.png");
  });
  EXPECT_EQ(outcome.exit, kExitInterrupted);
  EXPECT_THAT(outcome.err, HasSubstr("the same command with --resume, and without --record, makes the rest"));
  const RunOutcome resumed = run_kerf(with(arguments, {"--resume"}));
  EXPECT_EQ(resumed.exit, kExitHolds) << resumed.err;
}

TEST(InterruptedProgram, AScriptOfTheDebuggerLeavesNothingBehind) {
  const TemporaryFolder folder;
  const TemporaryFolder temporary;
  const auto pictures = folder.path() / "pictures";
  std::ofstream(folder.path() / "s") << "screenshot first\nwait 1000000\n";
  Arguments command = test::kerf_command({"debug", "pile", "--steps", "20", "--objects", "30", "--headless",
                                          "--script", folder.path() / "s", "--out", pictures});
  command.insert(command.begin(), {"env", "TMPDIR=" + temporary.path().string()});
  test::Process process(command);
  ASSERT_TRUE(test::holds_within_a_minute([&] { return std::filesystem::exists(pictures / "first.png"); }));
  process.signal(SIGINT);
  const RunOutcome outcome = process.wait();
  EXPECT_EQ(outcome.exit, kExitInterrupted);
  EXPECT_THAT(outcome.err, HasSubstr("interrupted while the script was played"));
  EXPECT_TRUE(temporary.files().empty());
}

bool has_open(pid_t process, const std::filesystem::path& file) {
  std::error_code none;
  for (const auto& entry :
       std::filesystem::directory_iterator("/proc/" + std::to_string(process) + "/fd", none))
    if (std::filesystem::read_symlink(entry.path(), none) == file) return true;
  return false;
}

/// They died by the signal.
TEST(InterruptedProgram, CommandsThatHaveNothingToLoseEndWithTheCodeOfTheirHelp) {
  const TemporaryFolder folder;
  const auto file = std::filesystem::canonical(folder.path()) / "pile.kerf";
  ASSERT_EQ(run_kerf({"record", "pile", "-o", file, "--steps", "400", "--objects", "400"}).exit, kExitHolds);
  for (const Arguments& arguments :
       {Arguments{"compare", file, file}, Arguments{"explain", file, "--step", "400", "--pair", "1,2"}})
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
      test::Process process(test::kerf_command(arguments));
      ASSERT_TRUE(test::holds_within_a_minute([&] { return has_open(process.id(), file); }));
      process.signal(signal);
      const RunOutcome outcome = process.wait();
      EXPECT_EQ(outcome.exit, kExitInterrupted) << arguments.front() << ", signal " << signal;
      EXPECT_EQ(outcome.err, "kerf: interrupted\n");
    }
}

/// SIGPIPE killed it without a word.
TEST(InterruptedProgram, AClosedPipeIsSaidWhereTheParentIgnoresItsSignal) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "pile.kerf";
  ASSERT_EQ(run_kerf({"record", "pile", "-o", file, "--steps", "2", "--objects", "20"}).exit, kExitHolds);
  const std::string kerf = test::kerf_command({}).front();
  const std::string script =
      "trap '' PIPE; { sleep 0.5; " + kerf + " verify " + file + "; echo $? >&2; } | true";
  test::Process process({"sh", "-c", script});
  EXPECT_EQ(process.wait().err, "kerf: cannot write standard output: what was printed is not whole\n2\n");
}

/// Parts of files stayed, and each later diff was refused.
TEST(InterruptedProgram, ApprovingEndsBetweenTwoFrames) {
  const TemporaryFolder folder;
  const auto reference = folder.path() / "reference";
  const auto test = folder.path() / "test";
  std::filesystem::create_directory(reference);
  std::filesystem::create_directory(test);
  constexpr int kFrames = 600;
  for (int k = 0; k < kFrames; ++k) {
    const std::string name = std::to_string(1000 + k) + ".png";
    write_png(reference / name, make_image(16, 16, 0xff203040U));
    write_png(test / name, make_image(16, 16, 0xff203041U));
  }
  const std::string earlier = test::read_text(reference / "1000.png");
  const RunOutcome outcome = interrupt_kerf({"diff", reference, test, "--approve"}, [&] {
    return test::read_text(reference / "1000.png") != earlier;
  });
  EXPECT_EQ(outcome.exit, kExitInterrupted) << outcome.err.substr(0, 200);
  EXPECT_THAT(outcome.err, testing::ContainsRegex("interrupted: [0-9]+ frames? (was|were) approved\n$"));
  EXPECT_EQ(test::files_in(reference), test::files_in(test));
  EXPECT_EQ(run_kerf({"diff", reference, test, "--approve"}).exit, kExitHolds);
}

}  // namespace
}  // namespace kerf::test
