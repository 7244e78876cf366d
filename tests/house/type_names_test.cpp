#include <gmock/gmock.h>

#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/house/project_files.h"

namespace kerf::house {
namespace {

using Definitions = std::map<std::string, std::set<std::string>>;  // files by type

/// Notes the types that a header defines in its first namespace: what begins a line and does not end with a
/// semicolon.
void note_types(const std::string& file, const std::vector<std::string>& lines, Definitions& definitions) {
  static const std::regex kNamespace(R"(^namespace ([\w: ]+) \{)");
  static const std::regex kType(
      R"(^(?:template <.*> )?(?:struct|class|enum class) (?:\[\[\w+\]\] ?|alignas\(.*\) )?(\w+)\b(?!::)[^;]*$)");
  std::string space;
  std::smatch match;
  for (const std::string& line : lines) {
    if (space.empty() && std::regex_search(line, match, kNamespace)) space = match[1];
    if (std::regex_search(line, match, kType)) definitions[space + "::" + match[1].str()].insert(file);
  }
}

/// "name: files" of each type with more than one header.
std::vector<std::string> ambiguous(const Definitions& definitions) {
  std::vector<std::string> found;
  for (const auto& [name, files] : definitions) {
    if (files.size() < 2) continue;
    std::string text = name + ":";
    for (const std::string& file : files) text += " " + file;
    found.push_back(text);
  }
  return found;
}

// Two types of one name in one program are undefined behaviour that no compiler and no linker sees: the
// inline functions of one serve both.
TEST(TypeNames, EachTypeIsDefinedInOneHeader) {
  Definitions definitions;
  for (const auto& file : source_files())
    if (file.extension() == ".h") note_types(file.string(), lines_of(file), definitions);
  EXPECT_GT(definitions.size(), 200U);
  EXPECT_THAT(ambiguous(definitions), testing::IsEmpty());
}

TEST(TypeNames, PlantedTwinsAreSeen) {
  Definitions definitions;
  note_types("a.h",
             {"namespace kerf {", "struct Forward;", "struct alignas(8) Twin {", "enum class Own : int {"},
             definitions);
  note_types(
      "b.h",
      {"namespace kerf {", "struct Forward;", "template <int D>", "class [[nodiscard]] Twin final : Base {"},
      definitions);
  note_types("c.h", {"namespace kerf::inline sims2d {", "struct Twin {", "  struct Own {"}, definitions);
  EXPECT_THAT(ambiguous(definitions), testing::ElementsAre("kerf::Twin: a.h b.h"));
}

}  // namespace
}  // namespace kerf::house
