#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "core/recording/recording_reader.h"
#include "tests/frames/program.h"

namespace kerf::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr const char* kSplit = "op==split && kind==acted";

/// What files commands replace, and when. There is a recording of some steps in which splits act.
class OutputProgram : public ::testing::Test {
 protected:
  void SetUp() override { record("a"); }

  void record(const std::string& name) const {
    const RunOutcome outcome =
        run_kerf({"record", "pile", "-o", file(name), "--steps", "20", "--objects", "40", "--grow", "10",
                  "--config", "min_threshold=4,max_threshold=8,schedule_interval=2"});
    ASSERT_EQ(outcome.exit, 0) << outcome.err;
  }
  /// Runs what must be refused as wrong usage, or must fail with another exit code, and answers why.
  static std::string refusal(const std::vector<std::string>& arguments, int exit = 2) {
    const RunOutcome outcome = run_kerf(arguments);
    EXPECT_EQ(outcome.exit, exit) << outcome.err;
    return outcome.err;
  }
  [[nodiscard]] std::string file(const std::string& name) const { return folder_.path() / (name + ".kerf"); }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path() / name; }
  [[nodiscard]] std::vector<std::string> files() const { return folder_.files(); }

 private:
  TemporaryFolder folder_;
};

TEST_F(OutputProgram, MinimizeNeverReplacesWhatItReads) {
  const std::string before = read_text(file("a"));
  EXPECT_THAT(refusal({"minimize", file("a"), "--when", kSplit, "-o", file("a"), "--overwrite"}),
              HasSubstr("which is read"));
  std::filesystem::create_symlink("a.kerf", file("link"));
  EXPECT_THAT(refusal({"minimize", file("a"), "--when", kSplit, "-o", file("link"), "--overwrite"}),
              HasSubstr("which is read"));
  EXPECT_EQ(read_text(file("a")), before);
}

TEST_F(OutputProgram, MinimizeKeepsAnEarlierResultUntilThereIsANewOne) {
  record("old");
  const std::string before = read_text(file("old"));
  refusal({"minimize", file("none"), "--when", kSplit, "-o", file("old"), "--overwrite"});
  refusal({"minimize", file("a"), "--when", "missed>0", "-o", file("old"), "--overwrite"}, 1);
  EXPECT_EQ(read_text(file("old")), before);
  EXPECT_EQ(files(), (std::vector<std::string>{"a.kerf", "old.kerf"}));
  ASSERT_EQ(run_kerf({"minimize", file("a"), "--when", kSplit, "-o", file("old"), "--overwrite"}).exit, 0);
  EXPECT_LT(RecordingReader<2>(file("old")).steps(), 20U);
  EXPECT_EQ(files(), (std::vector<std::string>{"a.kerf", "old.cpp", "old.kerf", "old.png"}));
}

/// Their names were not given, and may be those of a program that records itself.
TEST_F(OutputProgram, MinimizeReplacesOnlyATestOfItsOwnAndThePictureBesideIt) {
  record("sim");
  std::ofstream(path("sim.cpp")) << "int main() {}";
  std::ofstream(path("sim.png")) << "mine";
  std::vector<std::string> words{"minimize", file("a"), "--when", kSplit, "-o", file("sim")};
  EXPECT_THAT(refusal(words), AllOf(HasSubstr("sim.png, "), HasSubstr("sim.cpp exist already")));
  words.emplace_back("--overwrite");
  EXPECT_THAT(refusal(words), AllOf(HasSubstr("sim.png, "), HasSubstr("sim.cpp are not of an earlier")));
  EXPECT_EQ(read_text(path("sim.cpp")), "int main() {}");
  std::filesystem::remove(path("sim.cpp"));
  EXPECT_THAT(refusal(words), HasSubstr("sim.png is not of an earlier"));
  std::filesystem::remove(path("sim.png"));
  EXPECT_EQ(run_kerf(words).exit, 0);
  EXPECT_EQ(run_kerf(words).exit, 0) << "all of it is its own";
}

TEST_F(OutputProgram, MinimizeAsksBeforeItReplacesAPictureOrATest) {
  for (const char* const name : {"small.png", "small.cpp"}) {
    std::ofstream(path(name)) << "mine";
    EXPECT_THAT(refusal({"minimize", file("a"), "--when", kSplit, "-o", file("small")}),
                HasSubstr(std::string(name) + " exists already"));
    EXPECT_EQ(read_text(path(name)), "mine");
    EXPECT_FALSE(std::filesystem::exists(file("small")));
    std::filesystem::remove(path(name));
  }
}

TEST_F(OutputProgram, RerunKeepsAnEarlierRecordingWhenADecisionCannotBe) {
  record("old");
  const std::string before = read_text(file("old"));
  refusal({"rerun", file("a"), "-o", file("old"), "--overwrite", "--refuse", "e0"});
  EXPECT_EQ(read_text(file("old")), before);
}

TEST_F(OutputProgram, ExportReplacesFilesOnlyWhenAskedAndRecordingsNever) {
  std::ofstream(path("steps.csv")) << "mine";
  refusal({"export", file("none"), "--csv", "-o", path("steps.csv"), "--overwrite"});
  EXPECT_THAT(refusal({"export", file("a"), "--csv", "-o", path("steps.csv")}), HasSubstr("--overwrite"));
  EXPECT_EQ(read_text(path("steps.csv")), "mine");
  const std::string before = read_text(file("a"));
  EXPECT_THAT(refusal({"export", file("a"), "--csv", "-o", file("a"), "--overwrite"}),
              HasSubstr("which is read"));
  EXPECT_EQ(read_text(file("a")), before);
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  EXPECT_THAT(refusal({"export", file("a"), "--csv", "-o", path("pipe"), "--overwrite"}),
              HasSubstr("is no regular file"));
  EXPECT_TRUE(std::filesystem::is_fifo(path("pipe")));
  ASSERT_EQ(run_kerf({"export", file("a"), "--csv", "-o", path("steps.csv"), "--overwrite"}).exit, 0);
  EXPECT_EQ(read_text(path("steps.csv")), run_kerf({"export", file("a"), "--csv"}).out);
}

TEST_F(OutputProgram, ExportLeavesNoHalfFile) {
  const auto before = files();
  const RunOutcome outcome = run_kerf({"export", file("a"), "--boxes", "-o", path("boxes.csv")}, {1000, ""});
  EXPECT_EQ(outcome.exit, 2);
  EXPECT_THAT(outcome.err, HasSubstr("cannot write " + path("boxes.csv")));
  EXPECT_EQ(files(), before);
  EXPECT_THAT(refusal({"export", file("a"), "--csv", "-o", path("none/steps.csv")}),
              HasSubstr("none/steps.csv: No such file"));
}

/// A contact sheet took the place of a frame, and the manifest still spoke of the frame.
TEST_F(OutputProgram, NothingElseGetsTheNameOfAFrame) {
  const std::string frames = path("frames");
  std::filesystem::create_directory(frames);
  std::filesystem::create_symlink("frames", path("link"));
  const std::vector<std::string> render{"render", file("a"),     "--steps", "1:2",  "--size",
                                        "64x64",  "--overwrite", "--out",   frames, "--contact-sheet"};
  for (const std::string& sheet :
       {frames + "/a_000000.png", frames + "/./a_000007.png", path("link/a_000001.ids.png")}) {
    std::vector<std::string> command = render;
    command.push_back(sheet);
    EXPECT_THAT(refusal(command), HasSubstr("is the name of a file of the sequence in"));
  }
  EXPECT_THAT(refusal({"render", "pile", "--steps", "1:2", "--size", "64x64", "--out", frames, "--record",
                       frames + "/frames.json"}),
              HasSubstr("is the name of a file of the sequence in"));
  std::vector<std::string> command = render;
  command.push_back(frames + "/sheet.png");
  EXPECT_EQ(run_kerf(command).exit, 0);
  EXPECT_THAT(refusal({"collect", frames, "--out", path("all"), "--contact-sheet", path("all/a_000000.png")}),
              HasSubstr("is the name of a file of the sequence in"));
  EXPECT_FALSE(std::filesystem::exists(path("all")));
}

/// The page became a part of the reference, and the next comparison refused it.
TEST_F(OutputProgram, NothingIsWrittenIntoAFolderThatIsRead) {
  for (const std::string name : {"before", "after"})
    ASSERT_EQ(run_kerf({"render", file("a"), "--steps", "1", "--size", "64x64", "--out", path(name)}).exit,
              0);
  std::filesystem::create_symlink("before", path("link"));
  const std::string a = path("before");
  const std::string b = path("after");
  for (const char* const report : {"before/rep", "link/rep", "after/rep/below"})
    EXPECT_THAT(refusal({"diff", a, b, "--report", path(report)}),
                HasSubstr("which is read; choose another"));
  EXPECT_THAT(refusal({"diff", a, b, "--report", a}), HasSubstr("which is read"));
  EXPECT_THAT(refusal({"film-diff", a, b, "--out", path("after/d.mp4")}), HasSubstr("lies in " + b));
  EXPECT_THAT(refusal({"collect", a, "--contact-sheet", path("before/s.png")}), HasSubstr("lies in " + a));
  EXPECT_FALSE(std::filesystem::exists(path("before/rep")));
  EXPECT_EQ(run_kerf({"diff", a, b}).exit, 0) << "nothing was left there";
}

TEST_F(OutputProgram, ImportKeepsAnEarlierRecordingUntilThereIsANewOne) {
  const std::string before = read_text(file("a"));
  refusal({"import", path("none.csv"), "-o", file("a"), "--overwrite"});
  std::ofstream(path("boxes.csv")) << "1,0,0,1,0,1\n1,1,0,1,0,one\n";
  refusal({"import", path("boxes.csv"), "-o", file("a"), "--overwrite"});
  std::ofstream(path("boxes.csv")) << "1,0,0,1,0,1\n1,1,0,1,0,1\n";
  refusal({"import", path("boxes.csv"), "-o", file("a"), "--overwrite", "--pairs", path("none.csv")});
  EXPECT_EQ(read_text(file("a")), before);
  ASSERT_EQ(run_kerf({"import", path("boxes.csv"), "-o", file("a"), "--overwrite"}).exit, 0);
  EXPECT_EQ(RecordingReader<2>(file("a")).steps(), 1U);
  EXPECT_EQ(files(), (std::vector<std::string>{"a.kerf", "boxes.csv"}));
}

}  // namespace
}  // namespace kerf::test
