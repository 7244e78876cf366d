#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "frames/study/study.h"
#include "frames/support/errors.h"
#include "tests/frames/study/study_files.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

namespace fs = std::filesystem;

const fs::path kSource = KERF_SOURCE_DIR;

/// The first group of the expression in a text; empty if it does not match.
std::string found(const std::string& text, const char* expression) {
  std::smatch match;
  return std::regex_search(text, match, std::regex(expression)) ? match[1].str() : "";
}

TEST(StudyFiles, AreRead) {
  int files = 0;
  for (const auto& entry : fs::directory_iterator(kSource / "studies")) {
    EXPECT_FALSE(read_study(entry.path()).cells.empty()) << entry.path();
    ++files;
  }
  EXPECT_GE(files, 4);
  EXPECT_EQ(read_study(kSource / "studies/farm.json").cells.size(), 200U) << "as the documentation says";
}

TEST(StudyFiles, TheExampleOfTheDocumentationIsRead) {
  const std::string page = read_text(kSource / "docs/STUDIES.md");
  const std::size_t begin = page.find("```json\n") + 8;
  const StudyFolder study(page.substr(begin, page.find("```", begin) - begin));
  ASSERT_EQ(
      test::run_kerf({"record", "pile", "--steps", "100", "--objects", "4", "-o", study.path("run.kerf")})
          .exit,
      kExitHolds);
  // Two motions in two dimensions, two sizes, three seeds, five repeats: three trees and two others.
  EXPECT_EQ(read_study(study.path("study.json")).cells.size(), 2U * 2 * 2 * 3 * 5 * 5 + 20);
}

/// What the Job does in each of its pods, without a cluster: its own command, in a shell.
TEST(StudyFiles, TheJobOfKubernetesMakesAllCells) {
  const std::string job = read_text(kSource / "docs/farm/job.yaml");
  ASSERT_THAT(job, HasSubstr("completionMode: Indexed"));
  const std::string completions = found(job, "\n  completions: (\\d+)\n");
  ASSERT_FALSE(completions.empty());
  EXPECT_EQ(found(job, "name: SHARDS\n +value: \"(\\d+)\""), completions);
  const std::string study_in_it = found(job, "name: STUDY\n +value: (\\S+)");
  EXPECT_TRUE(fs::exists(kSource / study_in_it.substr(1))) << "the container has " << study_in_it;
  const std::string command = found(job, "- (exec kerf study .*)\n");
  ASSERT_FALSE(command.empty());
  const StudyFolder study;
  const std::string path = fs::path(test::kerf_command({}).front()).parent_path().string() + ":/usr/bin:/bin";
  for (int index = 0; index < std::stoi(completions); ++index) {
    const RunOutcome outcome =
        test::Process({"env", "PATH=" + path, "JOB_COMPLETION_INDEX=" + std::to_string(index),
                       "SHARDS=" + completions, "STUDY=" + study.path("study.json"),
                       "CELLS=" + study.path("cells"), "sh", "-c", command})
            .wait();
    ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  }
  EXPECT_EQ(study.run({"--join", "@cells", "-o", "@one"}).exit, kExitHolds);
}

}  // namespace
}  // namespace kerf::test
