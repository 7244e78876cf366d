#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace kerf::house {
namespace {

bool mentions(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

/// The command lines with which this build compiles its sources.
std::vector<std::string> compile_commands() {
  std::ifstream database(std::filesystem::path(KERF_BUILD_DIR) / "compile_commands.json");
  std::vector<std::string> commands;
  for (std::string line; std::getline(database, line);)
    if (mentions(line, "\"command\":")) commands.push_back(line);
  return commands;
}

/// What is compiled by those commands for which `is_wrong` holds.
template <class Predicate>
std::vector<std::string> sources_where(Predicate is_wrong) {
  std::vector<std::string> found;
  for (const std::string& command : compile_commands())
    if (is_wrong(command)) found.push_back(command.substr(command.rfind(" -c ")));
  return found;
}

TEST(CompileFlags, AreKnown) { EXPECT_THAT(compile_commands(), testing::SizeIs(testing::Gt(10))); }

// A product and a sum fused at one call site but not at another loses pairs (HARD_CASES N1).
TEST(CompileFlags, EverySourceIsCompiledWithoutContraction) {
  EXPECT_THAT(sources_where([](const std::string& command) {
                return !mentions(command, " -ffp-contract=off ") || mentions(command, "-ffp-contract=fast");
              }),
              testing::IsEmpty());
}

TEST(CompileFlags, NothingRelaxesFloatingPoint) {
  EXPECT_THAT(sources_where([](const std::string& command) {
                return mentions(command, "-ffast-math") || mentions(command, "-Ofast") ||
                       mentions(command, "-funsafe-math") || mentions(command, "-fassociative-math") ||
                       mentions(command, "-ffinite-math");
              }),
              testing::IsEmpty());
}

}  // namespace
}  // namespace kerf::house
