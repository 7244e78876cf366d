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

/// Notes the types and constants that begin a line of a source.
void note_local_names(const std::string& file, const std::vector<std::string>& lines,
                      Definitions& definitions) {
  static const std::regex kName(R"(^(?:(?:struct|class|enum class) (\w+)\b(?!::)[^;]*$)"
                                R"(|(?:inline )?constexpr [^=({]*\b(k[A-Z]\w*)(?:\[.*\])? ?[={]))");
  std::smatch match;
  for (const std::string& line : lines)
    if (std::regex_search(line, match, kName))
      definitions[match[1].matched ? match[1].str() : match[2].str()].insert(file);
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

// A user's build may compile sources of the library together, any number at a time. Kernels are compiled by
// themselves; the other folders are other libraries.
TEST(TypeNames, LocalNamesOfTheBroadPhaseDiffer) {
  static const std::regex kApart("^core/(kernels|scene|files|recording|replay|query|c)/");
  Definitions definitions;
  for (const auto& file : source_files())
    if (file.extension() == ".cpp" && file.string().starts_with("core/") &&
        !std::regex_search(file.string(), kApart))
      note_local_names(file.string(), lines_of(file), definitions);
  EXPECT_GT(definitions.size(), 60U);
  EXPECT_THAT(ambiguous(definitions), testing::IsEmpty());
}

TEST(TypeNames, PlantedLocalTwinsAreSeen) {
  Definitions definitions;
  note_local_names("a.cpp", {"constexpr std::size_t kWidth = 8;", "struct Piece {", "class Own {"},
                   definitions);
  note_local_names("b.cpp", {"constexpr std::array<int, 2> kWidth{1, 2};", "struct Piece final {"},
                   definitions);
  note_local_names("c.cpp",
                   {"  constexpr int kWidth = 3;", "struct Own;", "constexpr int f() { return kWidth; }"},
                   definitions);
  EXPECT_THAT(ambiguous(definitions), testing::ElementsAre("Piece: a.cpp b.cpp", "kWidth: a.cpp b.cpp"));
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
