#include <gmock/gmock.h>

#include <regex>

#include "tests/house/project_files.h"

namespace kerf::house {
namespace {

using testing::IsEmpty;

// Written with brackets, so that this file does not mention what it forbids.
const std::regex kUnfinished(R"(\b(T[O]DO|F[I]XME|X[X]X|H[A]CK)\b)");
const std::regex kMachinePath(R"((^|[^\w.}])/(h[o]me|r[o]ot|w[o]rk|U[s]ers|t[m]p)/)");
// Alternatives of a variant are distinguished by visits that name them all (core/base/overloaded.h,
// core/trace/event_facts.h): one that is added and forgotten somewhere does not compile.
const std::regex kOneAlternative(
    R"(\b(get_i[f]|holds_alternativ[e])\b|std::ge[t]<(Phase|Object|Operator|Events|All)[A-Z]\w*>)");

// What another engine recorded is numbered as it numbers it: GivenNames::step, never the number alone.
const std::regex kStepWithoutName(R"(steps? " \+ std::to_strin[g]|\bsteps? %[u])");

/// "file:line: text" of each line in which `forbidden` occurs.
std::vector<std::string> lines_with(const std::regex& forbidden) {
  std::vector<std::string> found;
  for (const std::filesystem::path& file : project_files()) {
    int number = 0;
    for (const std::string& line : lines_of(file)) {
      ++number;
      if (std::regex_search(line, forbidden))
        found.push_back(file.string() + ":" + std::to_string(number) + ": " + line);
    }
  }
  return found;
}

/// "file: lines" of each file with this ending that is longer than `limit`.
std::vector<std::string> longer_than(std::size_t limit, const std::string& ending) {
  std::vector<std::string> found;
  for (const std::filesystem::path& file : source_files()) {
    const std::size_t lines = lines_of(file).size();
    if (file.extension() == ending && lines > limit)
      found.push_back(file.string() + ": " + std::to_string(lines) + " lines");
  }
  return found;
}

TEST(TextRules, NothingIsMarkedUnfinished) { EXPECT_THAT(lines_with(kUnfinished), IsEmpty()); }

TEST(TextRules, NothingNamesAPathOfOneMachine) { EXPECT_THAT(lines_with(kMachinePath), IsEmpty()); }

TEST(TextRules, VariantsAreVisited) { EXPECT_THAT(lines_with(kOneAlternative), IsEmpty()); }

TEST(TextRules, StepsOfRecordingsHaveTheirNames) {
  std::vector<std::string> found = lines_with(kStepWithoutName);
  std::erase_if(found, [](const std::string& line) {
    const auto lies_in = [&](const char* folder) { return line.starts_with(folder); };
    return !lies_in("core/query/") && !lies_in("core/replay/") && !lies_in("core/recording/") &&
           !lies_in("viz/debugger/");
  });
  EXPECT_THAT(found, IsEmpty());
}

/// What patch, an editor or a merge leaves behind.
TEST(TextRules, NoFileIsLeftBehind) {
  const std::regex left_behind(R"(.*(\.(orig|rej|bak|swp|tmp)|~))");
  std::vector<std::filesystem::path> found = project_files();
  std::erase_if(found, [&](const auto& file) { return !std::regex_match(file.string(), left_behind); });
  EXPECT_THAT(found, IsEmpty());
}

TEST(TextRules, HeadersHaveAtMost200Lines) { EXPECT_THAT(longer_than(200, ".h"), IsEmpty()); }

TEST(TextRules, SourcesHaveAtMost400Lines) { EXPECT_THAT(longer_than(400, ".cpp"), IsEmpty()); }

}  // namespace
}  // namespace kerf::house
