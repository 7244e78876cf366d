// Where memory ends in the midst of a library, it is said, and nothing is called damaged.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "frames/support/errors.h"
#include "tests/frames/program.h"

namespace kerf::test {
namespace {

using ::testing::StartsWith;

class MemoryProgram : public ::testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path() / name; }

  /// Runs it in ever more memory, until it works. What lacks memory to begin with does not come to main.
  void expect_lack_is_said(const std::vector<std::string>& command) const {
    constexpr std::uint64_t kStep = std::uint64_t{384} << 10U;
    constexpr std::uint64_t kEnough = std::uint64_t{1} << 30U;
    int lacks = 0;
    for (std::uint64_t memory = 32 * kStep; memory < kEnough; memory += kStep) {
      const RunOutcome outcome = run_kerf(command, {.memory = memory});
      if (outcome.exit == kExitHolds) break;
      if (!outcome.err.starts_with("kerf: ")) continue;
      ++lacks;
      EXPECT_EQ(outcome.exit, kExitUnusable);
      EXPECT_THAT(outcome.err, StartsWith("kerf: not enough memory; ")) << memory << " bytes";
    }
    EXPECT_GT(lacks, 0) << command.front();
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(MemoryProgram, NoRecordingIsCalledDamagedForLackOfIt) {
  const std::string file = path("pile.kerf");
  ASSERT_EQ(run_kerf({"record", "pile", "-o", file, "--steps", "300", "--objects", "400"}).exit, kExitHolds);
  expect_lack_is_said({"verify", file, "--oracle-every", "0"});
  expect_lack_is_said({"compare", file, file});
  expect_lack_is_said({"rerun", file, "-o", path("again.kerf")});
}

}  // namespace
}  // namespace kerf::test
