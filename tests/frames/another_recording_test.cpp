#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "frames/support/errors.h"
#include "tests/frames/program.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

/// Recordings by one name that end in one state and are of different engines or of different boxes before.
class AnotherRecording : public ::testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path() / name; }
  void import(const std::string& middle, const std::string& pairs) const {
    std::ofstream(path("boxes.csv")) << "step,object,min_x,max_x,min_y,max_y\n1,0,0,1,0,1\n1,1,0.5,2,0,1\n"
                                     << "2,1," << middle << ",0,1\n3,1,0.5,2,0,1\n4,1,0.5,2,0,1\n";
    std::ofstream(path("pairs.csv")) << "step,a,b\n" << pairs;
    const RunOutcome outcome = run_kerf(
        {"import", path("boxes.csv"), "--pairs", path("pairs.csv"), "-o", path("run.kerf"), "--overwrite"});
    ASSERT_NE(outcome.exit, kExitUnusable) << outcome.err;
  }
  void import_right() const { import("0.5,2", "1,0,1\n2,0,1\n3,0,1\n4,0,1\n"); }
  void import_wrong() const { import("0.5,2", ""); }
  void import_other_boxes() const { import("5,6", "1,0,1\n3,0,1\n4,0,1\n"); }

  [[nodiscard]] RunOutcome render(const std::string& out, std::vector<std::string> more,
                                  const std::string& recording = "run.kerf") const {
    more.insert(more.begin(), {"render", path(recording), "--size", "96x64", "--steps", "1:4:1", "--workers",
                               "0", "--out", path(out)});
    return run_kerf(more);
  }

 private:
  TemporaryFolder folder_;
};

/// "all 4 frames are there" was said of half of each.
TEST_F(AnotherRecording, HasOtherShards) {
  import_wrong();
  ASSERT_EQ(render("wrong", {"--shard", "1/2"}).exit, kExitHolds);
  import_other_boxes();
  ASSERT_EQ(render("other", {"--shard", "1/2"}).exit, kExitHolds);
  import_right();
  ASSERT_EQ(render("right", {"--shard", "1/2"}).exit, kExitHolds);
  std::filesystem::create_directory(path("far"));  // another machine
  std::filesystem::copy_file(path("run.kerf"), path("far/run.kerf"));
  ASSERT_EQ(render("rest", {"--shard", "2/2"}, "far/run.kerf").exit, kExitHolds);
  for (const char* const shard : {"wrong", "other"}) {
    const RunOutcome mixed = run_kerf({"collect", path(shard), path("rest")});
    EXPECT_EQ(mixed.exit, kExitUnusable) << shard << mixed.out;
    EXPECT_THAT(mixed.err, HasSubstr("not of one sequence (recording: ")) << shard;
  }
  EXPECT_EQ(run_kerf({"collect", path("right"), path("rest")}).exit, kExitHolds);
}

TEST_F(AnotherRecording, IsNotResumed) {
  import_wrong();
  ASSERT_EQ(render("frames", {}).exit, kExitHolds);
  EXPECT_EQ(render("frames", {"--resume"}).exit, kExitHolds);
  for (const bool has_other_boxes : {false, true}) {
    has_other_boxes ? import_other_boxes() : import_right();
    const RunOutcome outcome = render("frames", {"--resume"});
    EXPECT_EQ(outcome.exit, kExitUnusable) << has_other_boxes;
    EXPECT_THAT(outcome.err, HasSubstr("holds another sequence (recording: ")) << has_other_boxes;
  }
}

/// Manifests of earlier versions do not say of which recording they are.
TEST_F(AnotherRecording, MayBeThatOfAnOldManifest) {
  import_right();
  ASSERT_EQ(render("frames", {}).exit, kExitHolds);
  std::string manifest = read_text(path("frames/frames.json"));
  const std::size_t identity = manifest.find("\"identity\"");
  ASSERT_NE(identity, std::string::npos);
  const std::size_t comma = manifest.rfind(',', identity);
  manifest.erase(comma, manifest.find('\n', identity) - comma);
  std::ofstream(path("frames/frames.json")) << manifest;
  const RunOutcome outcome = render("frames", {"--resume"});
  EXPECT_EQ(outcome.exit, kExitUnusable);
  EXPECT_THAT(outcome.err, HasSubstr("holds another sequence (recording: "));
}

/// "0 of them new" was said, and the frames of the replaced recording were joined.
TEST_F(AnotherRecording, HasOtherCells) {
  std::ofstream(path("study.json"))
      << R"({"matrices": [{"recording": "run.kerf", "steps": "1:4:1", "size": "96x64"}]})";
  import_wrong();
  ASSERT_EQ(run_kerf({"study", path("study.json"), "-o", path("cells")}).exit, kExitHolds);
  const auto before = files_in(path("cells"));
  import_right();
  ASSERT_EQ(run_kerf({"study", path("study.json"), "-o", path("cells")}).exit, kExitHolds);
  EXPECT_GT(files_in(path("cells")).size(), before.size());
  ASSERT_EQ(run_kerf({"study", path("study.json"), "--join", path("cells"), "-o", path("one")}).exit,
            kExitHolds);
  ASSERT_EQ(render("fresh", {}).exit, kExitHolds);
  for (const std::string& file : files_in(path("fresh")))
    EXPECT_TRUE(read_text(path("fresh/" + file)) == read_text(path("one/run/" + file))) << file;
}

/// Steps take other times each time, and pictures of one run recorded twice may be compared.
TEST_F(AnotherRecording, MayHaveTheSamePictures) {
  for (const char* const name : {"a", "b"}) {
    ASSERT_EQ(run_kerf({"record", "pile", "--steps", "20", "--objects", "30", "-o", path("run.kerf"),
                        "--overwrite"})
                  .exit,
              kExitHolds);
    ASSERT_EQ(render(name, {}).exit, kExitHolds);
  }
  const RunOutcome outcome = run_kerf({"diff", path("a"), path("b")});
  EXPECT_EQ(outcome.exit, kExitHolds) << outcome.out << outcome.err;
}

}  // namespace
}  // namespace kerf::test
