// README.md says what users type and embed: its first commands are run, its sample and those of ADAPTERS.md
// are the ones that are compiled.
#include <gmock/gmock.h>

#include <fstream>
#include <regex>

#include "frames/support/errors.h"
#include "tests/frames/program.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

std::string project_text(const std::string& file) { return read_text(KERF_SOURCE_DIR "/" + file); }

/// The part of README.md below a heading of the second level.
std::string section(const std::string& heading) {
  const std::string text = project_text("README.md");
  const std::size_t begin = text.find("\n## " + heading + "\n");
  if (begin == std::string::npos) throw std::runtime_error("README.md has no section " + heading);
  return text.substr(begin, text.find("\n## ", begin + 1) - begin);
}

/// The code blocks of one language, in order.
std::vector<std::string> blocks(const std::string& text, const std::string& language) {
  std::vector<std::string> found;
  const std::string fence = "\n```" + language + "\n";
  for (std::size_t at = text.find(fence); at != std::string::npos; at = text.find(fence, at + 1)) {
    const std::size_t begin = at + fence.size();
    found.push_back(text.substr(begin, text.find("```", begin) - begin));
  }
  return found;
}

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += text;
  return all;
}

/// A shell that finds `kerf`, opens no window and ends at the first mistake.
RunOutcome run_script(const std::string& script, const std::filesystem::path& folder) {
  const std::filesystem::path program = KERF_PROGRAM;
  const std::string begin =
      "set -e\ncd '" + folder.string() + "'\nPATH='" + program.parent_path().string() + "':$PATH\n" +
      "kerf() { if [ \"$1\" = debug ]; then set -- \"$@\" --headless --script empty; fi; "
      "command kerf \"$@\"; }\ntouch empty\n";
  Process shell({"sh", "-c", begin + script});
  return shell.wait();
}

TEST(ReadmeProgram, TheFirstCommandsWork) {
  const TemporaryFolder folder;
  const std::string text = section("First commands");
  const std::vector<std::string> csv = blocks(text, "csv");
  ASSERT_THAT(csv, SizeIs(2));
  std::ofstream(folder.path() / "boxes.csv") << csv[0];
  std::ofstream(folder.path() / "pairs.csv") << csv[1];
  const std::vector<std::string> commands = blocks(text, "sh");
  ASSERT_THAT(commands, SizeIs(4));
  const RunOutcome outcome = run_script(joined(commands), folder.path());
  EXPECT_EQ(outcome.exit, kExitHolds) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("1 missed, 1 extra"));
  for (const char* file :
       {"buckets.mp4", "terrain.mp4", "out/buckets/frames.json", "pile.kerf", "split.png", "theirs.kerf"})
    EXPECT_TRUE(std::filesystem::exists(folder.path() / file)) << file;
}

TEST(ReadmeProgram, TheSampleIsTheOneThatIsCompiled) {
  const std::string text = section("First commands");
  EXPECT_EQ(joined(blocks(text, "cpp")), project_text("tests/embed/main.cpp"));
  const std::string project = project_text("tests/embed/CMakeLists.txt");
  const std::string here = "add_subdirectory(../.. kerf";
  ASSERT_THAT(project, HasSubstr(here));
  const std::string beside =
      std::regex_replace(project, std::regex(R"(add_subdirectory\(\.\./\.\. kerf)"), "add_subdirectory(kerf");
  EXPECT_THAT(beside, HasSubstr(joined(blocks(text, "cmake"))));
}

TEST(ReadmeProgram, TheSamplesOfAdaptersAreThoseThatAreCompiled) {
  std::string compiled;
  for (const char* engine : {"bullet", "ode", "fcl", "box2d"})
    compiled += project_text(std::string("tests/embed/adapters/") + engine + ".cpp");
  EXPECT_EQ(joined(blocks(project_text("docs/ADAPTERS.md"), "cpp")), compiled);
}

std::string first_group(const std::string& text, const char* expression) {
  std::smatch match;
  return std::regex_search(text, match, std::regex(expression)) ? match[1].str() : std::string();
}

TEST(ReadmeProgram, OneVersionIsSaidEverywhere) {
  const std::string version = first_group(project_text("CMakeLists.txt"), R"(project\(Kerf VERSION (\S+))");
  EXPECT_EQ(test::run_kerf({"--version"}).out, "kerf " + version + "\n");
  EXPECT_EQ(first_group(project_text("CHANGELOG.md"), R"(\n## (\d+\.\d+\.\d+))"), version);
}

}  // namespace
}  // namespace kerf::test
