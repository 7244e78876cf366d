#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <climits>
#include <filesystem>
#include <fstream>

#include "tests/frames/program.h"

namespace kerf::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// Names that a URI, a shell, an option or an encoding could take for something else. Commands are run where
/// the files lie, so that nothing stands before the names.
class NamesProgram : public ::testing::TestWithParam<const char*> {
 protected:
  NamesProgram() : before_(fs::current_path()) { fs::current_path(folder_.path()); }
  ~NamesProgram() override { fs::current_path(before_); }

  [[nodiscard]] static std::string name(const std::string& ending) {
    const std::string stem = GetParam();
    if (stem == "long") return std::string(250 - ending.size(), 'n') + ending;
    if (stem == "longest") return std::string(NAME_MAX - ending.size(), 'n') + ending;
    return stem + ending;
  }
  /// Everything is a positional argument or the value of an option, so "--" ends the options.
  static RunOutcome run(const std::vector<std::string>& command) {
    const RunOutcome outcome = run_kerf(command);
    EXPECT_EQ(outcome.exit, 0) << ::testing::PrintToString(command) << outcome.err;
    return outcome;
  }
  [[nodiscard]] std::vector<std::string> files() const { return folder_.files(); }

 private:
  TemporaryFolder folder_;
  fs::path before_;
};

TEST_P(NamesProgram, EveryCommandTakesIt) {
  const std::string boxes = name(".csv");
  const std::string file = name(".kerf");
  std::ofstream(boxes) << "1,0,0,2,0,2\n1,1,1,3,1,3\n2,0,0,2,0,2\n";
  run({"import", "-o", file, "--", boxes});
  ASSERT_TRUE(fs::exists(file));
  run({"verify", "--", file});
  run({"step", "--to", "step==2", "--picture", "p.png", "--", file});
  run({"explain", "--pair", "0,1", "--", file});
  run({"compare", "--json", "--", file, file});
  run({"lint", "--", file});
  run({"rerun", "-o", "r.kerf", "--config", "min_threshold=4,max_threshold=8", "--", file});
  run({"minimize", "--when", "pairs>0", "-o", "m.kerf", "--", file});
  EXPECT_TRUE(nlohmann::json::accept(run({"export", "--chrome-trace", "--", file}).out));
  run({"export", "--boxes", "-o", "again.csv", "--", file});
  run({"render", "--steps", "1:2", "--size", "64x64", "--out", "frames", "--", file});
  run({"collect", "frames"});
  EXPECT_TRUE(nlohmann::json::accept(run({"diff", "--json", "frames", "frames"}).out));
  std::ofstream("script") << "expect step == 0\n";
  run({"debug", "--headless", "--script", "script", "--", file});
  for (const std::string& left : files()) EXPECT_FALSE(left.ends_with("-lock")) << left;
}

TEST_P(NamesProgram, ARecordingOfASceneHasIt) {
  const std::string file = name(".kerf");
  run({"record", "pile", "-o", file, "--steps", "5", "--objects", "5"});
  EXPECT_GT(fs::file_size(file), 1000U);
  run({"verify", "--", file});
  run({"record", "pile", "-o", file, "--steps", "5", "--objects", "5", "--overwrite"});
}

INSTANTIATE_TEST_SUITE_P(Kinds, NamesProgram,
                         ::testing::Values("plain", "file:x", "file:y?mode=memory&cache=shared", "-x",
                                           "a b%20#c", "\xff\xfe\x80", "long", "longest"));

}  // namespace
}  // namespace kerf::test
