#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "frames/support/errors.h"
#include "tests/frames/program.h"
#include "viz/image/png.h"

namespace kerf::test {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// A recording of 20 steps, and two shards of its eight frames.
class CollectProgram : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run_kerf({"record", "pile", "--steps", "20", "--objects", "30", "-o", path("run.kerf")}).exit,
              kExitHolds);
  }

  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path() / name; }
  void render(const std::string& out, const std::string& shard, std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"render", path("run.kerf"), "--steps", "6:20:2", "--size", "96x64",
                               "--workers", "0", "--shard", shard, "--out", path(out)});
    const RunOutcome outcome = run_kerf(more);
    ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  }
  [[nodiscard]] RunOutcome collect(const std::vector<std::string>& folders,
                                   const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"collect"};
    for (const std::string& folder : folders) words.push_back(path(folder));
    words.insert(words.end(), more.begin(), more.end());
    return run_kerf(words);
  }
  /// What all files of a folder hold, by name. There is no folder within.
  [[nodiscard]] std::map<std::string, std::string> contents(const std::string& folder) const {
    std::map<std::string, std::string> found;
    for (const auto& entry : fs::directory_iterator(path(folder))) {
      EXPECT_TRUE(entry.is_regular_file()) << entry.path();
      found[entry.path().filename().string()] = entry.is_regular_file() ? read_text(entry.path()) : "";
    }
    return found;
  }

 private:
  TemporaryFolder folder_;
};

/// The frames are links to those of the shards. A rename of one onto another does nothing: it was refused,
/// and what was there was no longer whole.
TEST_F(CollectProgram, ReplacesWhatItHasCollected) {
  render("s1", "1/2", {"--ids"});
  render("s2", "2/2", {"--ids"});
  const std::vector<std::string> out{"--out", path("all"), "--overwrite"};
  ASSERT_EQ(collect({"s1", "s2"}, out).exit, kExitHolds);
  const auto whole = contents("all");
  ASSERT_EQ(whole.size(), 1U + 3 * 8);
  const RunOutcome again = collect({"s1", "s2"}, out);
  EXPECT_EQ(again.exit, kExitHolds) << again.err;
  EXPECT_EQ(contents("all"), whole);
  render("s1", "1/2", {"--ids", "--overwrite"});
  ASSERT_EQ(collect({"s1", "s2"}, out).exit, kExitHolds);
  EXPECT_EQ(contents("all"), whole);
}

TEST_F(CollectProgram, ReplacesWhatAKilledCollectHasLeft) {
  render("s1", "1/2");
  render("s2", "2/2");
  const std::vector<std::string> out{"--out", path("all"), "--overwrite"};
  ASSERT_EQ(collect({"s1", "s2"}, out).exit, kExitHolds);
  const auto whole = contents("all");
  auto manifest = read_json(path("all/frames.json"));
  manifest["complete"] = false;
  std::ofstream(path("all/frames.json")) << manifest.dump();
  const std::string part = path("all/run.0123456789abcdef.part");
  fs::create_directory(part);
  for (const char* const frame : {"/run_000003.png", "/run_000004.png"})
    fs::create_hard_link(path("all") + frame, part + frame);
  fs::remove(path("all/run_000005.png"));
  ASSERT_EQ(collect({"s1", "s2"}, out).exit, kExitHolds);
  EXPECT_EQ(contents("all"), whole);
}

TEST_F(CollectProgram, JoinedFramesAreReplacedToo) {
  std::ofstream(path("study.json"))
      << R"({"matrices": [{"recording": "run.kerf", "size": "96x64", "steps": "6:20:2", "parts": 2}]})";
  ASSERT_EQ(run_kerf({"study", path("study.json"), "-o", path("cells")}).exit, kExitHolds);
  const std::vector<std::string> join{"study", path("study.json"), "--join",     path("cells"),
                                      "-o",    path("one"),        "--overwrite"};
  ASSERT_EQ(run_kerf(join).exit, kExitHolds);
  const auto whole = contents("one/run");
  const RunOutcome again = run_kerf(join);
  EXPECT_EQ(again.exit, kExitHolds) << again.err;
  EXPECT_EQ(contents("one/run"), whole);
}

/// The pictures of the second folder were not read.
TEST_F(CollectProgram, JoinReadsThePicturesOfAllFolders) {
  std::ofstream(path("study.json"))
      << R"({"matrices": [{"recording": "run.kerf", "size": "96x64", "steps": "6:20:2", "parts": 1}]})";
  ASSERT_EQ(run_kerf({"study", path("study.json"), "-o", path("a")}).exit, kExitHolds);
  fs::copy(path("a"), path("b"), fs::copy_options::recursive);
  for (const auto& entry : fs::recursive_directory_iterator(path("b")))
    if (entry.path().filename() == "run_000002.png") std::ofstream(entry.path()) << "no picture";
  for (const auto& [first, second] : {std::pair{"a", "b"}, {"b", "a"}}) {
    const RunOutcome outcome =
        run_kerf({"study", path("study.json"), "--join", path(first), path(second), "-o", path("one")});
    EXPECT_EQ(outcome.exit, kExitUnusable) << first;
    EXPECT_THAT(outcome.err, AllOf(HasSubstr(path("b/")), HasSubstr("run_000002.png"))) << first;
  }
}

/// The first folder won, whatever it had.
TEST_F(CollectProgram, TakesTheGoodFrameOfTwoFolders) {
  render("good", "1/2");
  render("rest", "2/2");
  fs::copy(path("good"), path("bad"));
  fs::copy(path("good"), path("worse"));
  std::ofstream(path("bad/run_000002.png")) << "no picture";
  fs::copy_file(path("good/run_000000.png"), path("worse/run_000002.png"),
                fs::copy_options::overwrite_existing);
  const std::vector<std::string> out{"--out", path("all"), "--overwrite"};
  for (const auto& folders : std::vector<std::vector<std::string>>{
           {"bad", "good", "rest"}, {"good", "bad", "rest"}, {"worse", "bad", "rest", "good"}}) {
    const RunOutcome outcome = collect(folders, out);
    EXPECT_EQ(outcome.exit, kExitHolds) << folders[0] << outcome.err;
    EXPECT_TRUE(read_text(path("all/run_000002.png")) == read_text(path("good/run_000002.png")))
        << folders[0];
  }
  const RunOutcome none = collect({"bad", "rest", "worse"});
  EXPECT_EQ(none.exit, kExitDoesNotHold);
  EXPECT_THAT(none.err,
              AllOf(HasSubstr(path("bad/run_000002.png")), HasSubstr(path("worse/run_000002.png"))));
}

/// "all frames are there" was said, and --out had what there was.
TEST_F(CollectProgram, ReadsWhatLiesBesideFrames) {
  render("ids", "1/2", {"--ids"});
  render("rest", "2/2", {"--ids"});
  render("without", "1/2");
  const auto expect_trouble = [&](const std::string& folder, const std::string& trouble) {
    const RunOutcome outcome = collect({folder, "rest"}, {"--out", path("all")});
    EXPECT_EQ(outcome.exit, kExitDoesNotHold) << trouble;
    EXPECT_THAT(outcome.err, AllOf(HasSubstr(trouble), HasSubstr("--ids, --resume and --shard 1/2")));
    EXPECT_FALSE(fs::exists(path("all")));
  };
  ASSERT_EQ(collect({"ids", "rest"}).exit, kExitHolds);
  expect_trouble("without", path("without/run_000000.ids.png") + " is missing");
  EXPECT_EQ(collect({"without", "ids", "rest"}).exit, kExitHolds) << "those with ids are taken";
  fs::remove(path("ids/run_000002.ids.png"));
  expect_trouble("ids", path("ids/run_000002.ids.png") + " is missing");
  render("ids", "1/2", {"--ids", "--resume"});
  std::ofstream(path("ids/run_000004.draw.json")) << "rubbish";
  expect_trouble("ids", "it is no draw list");
  fs::remove(path("ids/run_000004.draw.json"));
  expect_trouble("ids", path("ids/run_000004.draw.json") + " is missing");
  render("ids", "1/2", {"--ids", "--resume"});
  write_png(path("ids/run_000006.ids.png"), make_image(8, 8, 0x000000ffU), Replace::earlier);
  expect_trouble("ids", "has another size than its frame");
}

}  // namespace
}  // namespace kerf::test
