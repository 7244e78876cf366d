#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "frames/support/errors.h"
#include "tests/frames/study/study_files.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

namespace fs = std::filesystem;

/// The cell was "there" without them, and none of the commands drew them again.
TEST(LostPictures, AreDrawnAgainByTheSameCommand) {
  const FramesStudy study("10:40:10", "2");
  ASSERT_EQ(study.run({"-o", "@all"}).exit, kExitHolds);
  const std::string cell = "all/" + study.cells("all").front();
  const std::string folder = "all/" + fs::path(cell).stem().string();
  std::string picture;
  for (const std::string& file : test::files_in(study.path(folder)))
    if (file.ends_with(".png")) picture = file;
  const std::string drawn = read_text(study.path(folder + "/" + picture));
  const std::string figures = read_text(study.path(cell));
  ASSERT_TRUE(fs::remove(study.path(folder + "/" + picture)));

  EXPECT_THAT(study.run({"--list", "-o", "@all"}).out, HasSubstr("  missing"));
  const RunOutcome refused = study.run({"--join", "@all", "-o", "@one"});
  EXPECT_EQ(refused.exit, kExitUnusable);
  EXPECT_THAT(refused.err, HasSubstr(" lacks " + picture + "; measure it again"));

  const RunOutcome again = study.run({"-o", "@all"});
  ASSERT_EQ(again.exit, kExitHolds) << again.err;
  EXPECT_THAT(again.out, HasSubstr("1 of them new"));
  EXPECT_TRUE(read_text(study.path(folder + "/" + picture)) == drawn);
  EXPECT_EQ(read_text(study.path(cell)), figures);
  EXPECT_THAT(study.run({"--list", "-o", "@all"}).out, Not(HasSubstr("missing")));
  EXPECT_EQ(study.run({"--join", "@all", "-o", "@one"}).exit, kExitHolds);
}

}  // namespace
}  // namespace kerf::test
