#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace kerf::house {
namespace {

/// The command lines with which this build compiles its sources.
std::vector<std::string> compile_commands() {
  std::ifstream database(std::filesystem::path(KERF_BUILD_DIR) / "compile_commands.json");
  std::vector<std::string> commands;
  for (std::string line; std::getline(database, line);)
    if (line.find("\"command\":") != std::string::npos) commands.push_back(line);
  return commands;
}

// A product and a sum fused at one call site but not at another loses pairs (HARD_CASES N1).
TEST(CompileFlags, EverySourceIsCompiledWithoutContraction) {
  ASSERT_FALSE(compile_commands().empty());
  for (const std::string& command : compile_commands()) {
    EXPECT_THAT(command, testing::HasSubstr(" -ffp-contract=off "));
    EXPECT_THAT(command, testing::Not(testing::ContainsRegex("-ffp-contract=(fast|on)")));
  }
}

TEST(CompileFlags, NothingRelaxesFloatingPoint) {
  for (const std::string& command : compile_commands()) {
    EXPECT_THAT(command, testing::Not(testing::ContainsRegex(
                             "-ffast-math|-Ofast|-funsafe-math|-fassociative-math|-ffinite-math")));
  }
}

}  // namespace
}  // namespace kerf::house
