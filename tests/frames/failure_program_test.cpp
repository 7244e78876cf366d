#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "frames/sequence/manifest.h"
#include "frames/support/errors.h"
#include "tests/frames/program.h"
#include "viz/image/png.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

std::vector<std::string> long_render(const std::filesystem::path& out) {
  return {"render", "pile", "--steps", "1:1000000:1", "--objects", "50", "--size", "160x120", "--out", out};
}

bool appears(const std::filesystem::path& file) {
  return holds_within_a_minute([&] { return std::filesystem::exists(file); });
}

/// What is in `folder` is a valid part of a sequence: an incomplete manifest that names the frames that are
/// there, each with the pixels that it says. `may_have_next`: the next frame may be there, too, of which the
/// manifest does not know yet: a worker that is killed has perhaps just written it.
void expect_valid_part(const std::filesystem::path& folder, bool may_have_next = false) {
  const nlohmann::json manifest = test::read_json(folder / "frames.json");
  EXPECT_EQ(manifest["complete"], false);
  std::vector<std::string> expected{"frames.json"};
  for (const nlohmann::json& frame : manifest["frames"]) {
    expected.push_back(frame["file"]);
    const std::uint64_t hash = pixel_hash(read_png(folder / frame["file"].get<std::string>()));
    EXPECT_EQ(std::stoull(frame["pixel_hash"].get<std::string>(), nullptr, 16), hash);
  }
  const std::string next = frame_file_name("pile", static_cast<std::uint32_t>(manifest["frames"].size()));
  if (may_have_next && std::filesystem::exists(folder / next)) expected.push_back(next);
  EXPECT_THAT(test::files_in(folder), ::testing::UnorderedElementsAreArray(expected));
}

class FailureProgram : public ::testing::TestWithParam<int> {};

TEST_P(FailureProgram, SignalLeavesAValidPart) {
  const TemporaryFolder folder;
  auto arguments = long_render(folder.path() / "frames");
  arguments.insert(arguments.end(), {"--video", folder.path() / "film.mp4"});
  Process process(test::kerf_command(arguments));
  ASSERT_TRUE(appears(folder.path() / "frames" / "pile_000003.png"));
  process.signal(GetParam());
  const RunOutcome outcome = process.wait();
  EXPECT_EQ(outcome.exit, kExitInterrupted);
  EXPECT_THAT(outcome.err, HasSubstr("interrupted"));
  EXPECT_EQ(folder.files(), std::vector<std::string>{"frames"}) << "half a film is no film";
  expect_valid_part(folder.path() / "frames");
  EXPECT_GE(test::read_json(folder.path() / "frames" / "frames.json")["frames"].size(), 4U);
}

INSTANTIATE_TEST_SUITE_P(Signals, FailureProgram, ::testing::Values(SIGINT, SIGTERM, SIGHUP),
                         [](const ::testing::TestParamInfo<int>& signal) {
                           return signal.param == SIGINT    ? "Interrupt"
                                  : signal.param == SIGTERM ? "Terminate"
                                                            : "HangUp";
                         });

/// The processes that a program has forked.
std::vector<pid_t> children_of(pid_t parent) {
  const std::string task =
      "/proc/" + std::to_string(parent) + "/task/" + std::to_string(parent) + "/children";
  std::ifstream file(task);
  return {std::istream_iterator<pid_t>(file), {}};
}

bool goes_away(pid_t process) {
  return holds_within_a_minute([&] { return ::kill(process, 0) != 0; });
}

/// The same files with the same bytes.
void expect_same_folder(const std::filesystem::path& a, const std::filesystem::path& b) {
  ASSERT_EQ(test::files_in(a), test::files_in(b));
  for (const std::string& file : test::files_in(a))
    EXPECT_TRUE(test::read_text(a / file) == test::read_text(b / file)) << file;
}

TEST(FailureProgram, KilledRunLeavesNoProcessAndIsResumed) {
  const TemporaryFolder folder;
  const auto all = folder.path() / "all";
  const auto part = folder.path() / "part";
  const auto arguments = short_render(part, "1:2000:10");
  Process process(test::kerf_command(with(arguments, {"--workers", "2"})));
  ASSERT_TRUE(appears(part / "pile_000003.png"));
  const std::vector<pid_t> workers = children_of(process.id());
  EXPECT_EQ(workers.size(), 2U);
  process.signal(SIGKILL);
  EXPECT_EQ(process.wait().exit, 128 + SIGKILL);
  for (const pid_t worker : workers) EXPECT_TRUE(goes_away(worker)) << worker;
  EXPECT_EQ(test::read_json(part / "frames.json")["complete"], false);

  EXPECT_EQ(run_kerf(arguments).exit, kExitUnusable) << "nothing is mixed unless asked for";
  const RunOutcome other = run_kerf(with(arguments, {"--resume", "--camera", "width=9"}));
  EXPECT_EQ(other.exit, kExitUnusable);
  EXPECT_THAT(other.err, HasSubstr("camera"));
  const RunOutcome resumed = run_kerf(with(arguments, {"--resume"}));
  ASSERT_EQ(resumed.exit, kExitHolds) << resumed.err;
  ASSERT_EQ(run_kerf(short_render(all, "1:2000:10")).exit, kExitHolds);
  expect_same_folder(part, all);
}

TEST(FailureProgram, ResumedFramesAreLookedAt) {
  const TemporaryFolder folder;
  const auto part = folder.path() / "part";
  ASSERT_EQ(run_kerf(short_render(part, "1:41:10")).exit, kExitHolds);
  const std::string whole = test::read_text(part / "pile_000001.png");
  const std::string before = test::read_text(part / "frames.json");
  std::filesystem::resize_file(part / "pile_000001.png", 100);
  std::filesystem::copy_file(part / "pile_000003.png", part / "pile_000002.png",
                             std::filesystem::copy_options::overwrite_existing);
  std::filesystem::remove(part / "pile_000004.png");
  const RunOutcome outcome = run_kerf(with(short_render(part, "1:41:10"), {"--resume"}));
  ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  EXPECT_TRUE(test::read_text(part / "pile_000001.png") == whole);
  EXPECT_EQ(test::read_text(part / "frames.json"), before);
  for (const nlohmann::json& frame : test::read_json(part / "frames.json")["frames"])
    EXPECT_EQ(std::stoull(frame["pixel_hash"].get<std::string>(), nullptr, 16),
              pixel_hash(read_png(part / frame["file"].get<std::string>())));
}

TEST(FailureProgram, FramesOfAKilledWorkerAreDrawnByTheOthers) {
  const TemporaryFolder folder;
  const auto out = folder.path() / "a";
  Process process(test::kerf_command(with(short_render(out, "1:2000:10"), {"--workers", "3"})));
  ASSERT_TRUE(appears(out / "pile_000003.png"));
  const std::vector<pid_t> workers = children_of(process.id());
  ASSERT_EQ(workers.size(), 3U);
  ::kill(workers[1], SIGKILL);
  const RunOutcome outcome = process.wait();
  EXPECT_EQ(outcome.exit, kExitHolds) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("killed by signal 9"));
  ASSERT_EQ(run_kerf(with(short_render(folder.path() / "b", "1:2000:10"), {"--workers", "0"})).exit,
            kExitHolds);
  expect_same_folder(out, folder.path() / "b");
}

TEST(FailureProgram, WithoutAnyWorkerItIsAnErrorThatCanBeResumed) {
  const TemporaryFolder folder;
  Process process(test::kerf_command(with(long_render(folder.path()), {"--workers", "1"})));
  ASSERT_TRUE(appears(folder.path() / "pile_000003.png"));
  ::kill(children_of(process.id()).at(0), SIGKILL);
  const RunOutcome outcome = process.wait();
  EXPECT_EQ(outcome.exit, kExitUnusable);
  EXPECT_THAT(outcome.err, HasSubstr("--resume"));
  expect_valid_part(folder.path(), true);
}

TEST(FailureProgram, TwoRendersIntoOneFolder) {
  const TemporaryFolder folder;
  Process first(test::kerf_command(long_render(folder.path())));
  ASSERT_TRUE(appears(folder.path() / "pile_000003.png"));
  for (const char* const how : {"--overwrite", "--resume"}) {
    const RunOutcome second = run_kerf(with(long_render(folder.path()), {how}));
    EXPECT_EQ(second.exit, kExitUnusable) << how;
    EXPECT_THAT(second.err, HasSubstr("another render is writing"));
  }
  first.signal(SIGINT);
  EXPECT_EQ(first.wait().exit, kExitInterrupted);
  expect_valid_part(folder.path());
}

TEST(FailureProgram, FolderThatCannotBeMade) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "file") << "x";
  for (const std::filesystem::path& out :
       {std::filesystem::path("/proc/kerf"), folder.path() / "file" / "below"}) {
    const RunOutcome outcome = run_kerf(long_render(out));
    EXPECT_EQ(outcome.exit, kExitUnusable);
    EXPECT_THAT(outcome.err, HasSubstr(out.string()));
    EXPECT_THAT(outcome.err, HasSubstr("--out"));
  }
  const RunOutcome file = run_kerf(long_render(folder.path() / "file"));
  EXPECT_EQ(file.exit, kExitUnusable);
  EXPECT_THAT(file.err, HasSubstr("not a folder"));
}

TEST(FailureProgram, FileThatMayNotGrowIsAnError) {
  const TemporaryFolder folder;
  const RunOutcome outcome = run_kerf(long_render(folder.path()), {2000, ""});
  EXPECT_EQ(outcome.exit, kExitUnusable);
  EXPECT_THAT(outcome.err, ::testing::ContainsRegex("pile_00000[0-9].png"));  // whichever worker was first
  EXPECT_THAT(outcome.err, HasSubstr("too large"));
  EXPECT_THAT(test::files_in(folder.path()), ::testing::Not(::testing::Contains("pile_000000.png")));
}

/// A file system of 300 kB in a mount namespace of its own, which takes a few dozen frames.
TEST(FailureProgram, FullDiskLeavesAValidPart) {
  const TemporaryFolder folder;
  const std::string disk = folder.path() / "disk";
  std::filesystem::create_directory(disk);
  if (Process({"unshare", "-m", "mount", "-t", "tmpfs", "tmpfs", disk}).wait().exit != 0) {
    GTEST_SKIP() << "this user may not mount";
  }
  std::string line = "mount -t tmpfs -o size=300k tmpfs " + disk + " && ";
  for (const std::string& word : test::kerf_command(long_render(disk))) line += word + " ";
  line += "; code=$?; cp -r " + disk + " " + (folder.path() / "copy").string() + "; exit $code";
  const RunOutcome outcome = Process({"unshare", "-m", "sh", "-c", line}).wait();
  EXPECT_EQ(outcome.exit, kExitUnusable);
  EXPECT_THAT(outcome.err, HasSubstr("No space left"));
  EXPECT_THAT(outcome.err, HasSubstr("free some space"));
  expect_valid_part(folder.path() / "copy");
}

/// What each command prints fits into memory until it ends.
TEST(FailureProgram, WhatIsPrintedIntoAFullDeviceIsAnError) {
  const TemporaryFolder folder;
  const std::string recording = folder.path() / "a.kerf";
  ASSERT_EQ(run_kerf({"record", "pile", "--objects", "30", "--steps", "20", "-o", recording}).exit,
            kExitHolds);
  ASSERT_EQ(
      run_kerf({"render", recording, "--steps", "1:2:1", "--size", "320x240", "--out", folder.path() / "x"})
          .exit,
      kExitHolds);
  const std::string frames = folder.path() / "x";
  for (const std::string& arguments : std::vector<std::string>{
           "scenes", "doctor", "man", "completion fish", "--help", "--version", "step --help",
           "verify " + recording, "step " + recording + " --to step==9",
           "step " + recording + " --to step==9 --hits 2", "explain " + recording + " --step 9 --pair 1,2",
           "compare " + recording + " " + recording, "lint " + recording, "export " + recording + " --csv",
           "advise " + recording + " --broad-phases kerf,columns --rounds 2",
           "diff " + frames + " " + frames}) {
    const RunOutcome outcome =
        Process({"sh", "-c", std::string(KERF_PROGRAM) + " " + arguments + " > /dev/full"}).wait();
    EXPECT_EQ(outcome.exit, kExitUnusable) << arguments;
    EXPECT_THAT(outcome.err, HasSubstr("standard output")) << arguments;
  }
}

/// A verdict whose text is lost is none.
TEST(FailureProgram, ADifferenceThatCannotBePrintedIsAnError) {
  const TemporaryFolder folder;
  const std::string a = folder.path() / "a.kerf";
  const std::string b = folder.path() / "b.kerf";
  for (const auto& [file, seed] : {std::pair{a, "1"}, {b, "2"}}) {
    ASSERT_EQ(
        run_kerf({"record", "pile", "--objects", "30", "--steps", "5", "--seed", seed, "-o", file}).exit,
        kExitHolds);
    ASSERT_EQ(run_kerf({"render", file, "--steps", "5:5:1", "--size", "320x240", "--out", file + ".d"}).exit,
              kExitHolds);
  }
  for (const std::string& arguments :
       {"compare " + a + " " + b, "diff " + a + ".d " + b + ".d", "diff --json " + a + ".d " + b + ".d"}) {
    EXPECT_EQ(Process({"sh", "-c", std::string(KERF_PROGRAM) + " " + arguments}).wait().exit,
              kExitDoesNotHold);
    const RunOutcome lost =
        Process({"sh", "-c", std::string(KERF_PROGRAM) + " " + arguments + " > /dev/full"}).wait();
    EXPECT_EQ(lost.exit, kExitUnusable) << arguments;
    EXPECT_THAT(lost.err, HasSubstr("standard output")) << arguments;
  }
}

/// 1 is an answer of these commands.
TEST(FailureProgram, WhatIsNoRecordingHasAnExitCodeOfItsOwn) {
  const TemporaryFolder folder;
  const std::string recording = folder.path() / "a.kerf";
  ASSERT_EQ(run_kerf({"record", "terrain", "--objects", "30", "--steps", "3", "-o", recording}).exit,
            kExitHolds);
  const std::string flat = folder.path() / "flat.kerf";
  ASSERT_EQ(run_kerf({"record", "terrain-2d", "--objects", "30", "--steps", "3", "-o", flat}).exit,
            kExitHolds);
  const std::string none = folder.path() / "none.kerf";
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"compare", recording, none},
                                             {"compare", none, recording},
                                             {"compare", recording, flat},
                                             {"lint", none},
                                             {"step", none, "--to", "step==1"}}) {
    const RunOutcome outcome = run_kerf(command);
    EXPECT_EQ(outcome.exit, kExitUnusable) << command.front() << outcome.err;
  }
}

struct Unwritable {
  const char* name;
  std::vector<std::string> arguments;  ///< after them the file that cannot be
  std::string option;                  ///< that the advice names; empty: none
};

class UnwritablePlace : public ::testing::TestWithParam<Unwritable> {};

/// No file can be made in /proc. The message has the path, the reason and the option that the command
/// has.
TEST_P(UnwritablePlace, IsNamedWithItsReasonAndItsOption) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "a.kerf";
  const std::string frames = folder.path() / "frames";
  const std::string film = folder.path() / "film.gif";
  ASSERT_EQ(run_kerf({"record", "pile", "--steps", "5", "--objects", "20", "-o", file}).exit, 0);
  ASSERT_EQ(run_kerf({"render", file, "--size", "64x64", "--out", frames}).exit, 0);
  std::vector<std::string> arguments;
  for (const std::string& word : GetParam().arguments)
    arguments.push_back(word == "FILE" ? file : word == "FRAMES" ? frames : word == "FILM" ? film : word);
  const RunOutcome outcome = run_kerf(arguments);
  EXPECT_NE(outcome.exit, 0);
  EXPECT_THAT(outcome.err, HasSubstr("/proc/no"));
  EXPECT_THAT(outcome.err, HasSubstr("No such file or directory"));
  const std::size_t advice = outcome.err.find("with --");
  const bool advises = advice != std::string::npos;
  EXPECT_EQ(advises ? outcome.err.substr(advice + 5) : "\n", GetParam().option + "\n");
}

INSTANTIATE_TEST_SUITE_P(
    FailureProgram, UnwritablePlace,
    ::testing::Values(
        Unwritable{"Diff", {"diff", "FRAMES", "FRAMES", "--report", "/proc/no"}, "--report"},
        Unwritable{"Film", {"film", "FILE", "-o", "/proc/no/a.mp4"}, "--out"},
        Unwritable{"FilmStill", {"film", "FILE", "-o", "FILM", "--still", "/proc/no/a.png"}, "--still"},
        Unwritable{"FilmDiff", {"film-diff", "FRAMES", "FRAMES", "-o", "/proc/no/a.mp4"}, "--out"},
        Unwritable{"FilmDiffSheet",
                   {"film-diff", "FRAMES", "FRAMES", "-o", "FILM", "--contact-sheet", "/proc/no/a.png"},
                   "--contact-sheet"},
        Unwritable{"Collect", {"collect", "FRAMES", "--video", "/proc/no/a.mp4"}, "--video"},
        Unwritable{
            "CollectSheet", {"collect", "FRAMES", "--contact-sheet", "/proc/no/a.png"}, "--contact-sheet"},
        Unwritable{"Render", {"render", "FILE", "--out", "/proc/no"}, "--out"},
        Unwritable{"Step", {"step", "FILE", "--to", "step==3", "--picture", "/proc/no/a.png"}, ""},
        Unwritable{"Export", {"export", "FILE", "--csv", "-o", "/proc/no/a.csv"}, ""},
        Unwritable{"Record", {"record", "pile", "--steps", "3", "-o", "/proc/no.kerf"}, ""}),
    [](const ::testing::TestParamInfo<Unwritable>& place) { return std::string(place.param.name); });

/// The advice names no option that the command may not have.
TEST(FailureProgram, APictureOnAFullDiskIsAnError) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "a.kerf";
  const std::string disk = folder.path() / "disk";
  std::filesystem::create_directory(disk);
  ASSERT_EQ(run_kerf({"record", "pile", "--steps", "5", "--objects", "20", "-o", file}).exit, 0);
  if (Process({"unshare", "-m", "mount", "-t", "tmpfs", "tmpfs", disk}).wait().exit != 0)
    GTEST_SKIP() << "this user may not mount";
  const std::string line = "mount -t tmpfs -o size=4k tmpfs " + disk + " && " + KERF_PROGRAM + " step " +
                           file + " --to step==3 --picture " + disk + "/a.png";
  const RunOutcome outcome = Process({"unshare", "-m", "sh", "-c", line}).wait();
  EXPECT_EQ(outcome.exit, kExitUnusable);
  EXPECT_THAT(outcome.err, HasSubstr("free some space"));
  EXPECT_THAT(outcome.err, ::testing::Not(HasSubstr("--out")));
}

}  // namespace
}  // namespace kerf::test
