#include <gmock/gmock.h>

#include <algorithm>
#include <regex>
#include <string>

#include "tests/house/project_files.h"

namespace kerf::house {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

// Phrases over which readers stumbled: objects are `it`, pairs are reported, pages and values show.
const std::regex kStumbling(
    R"(\b(who|whoever|nobody|somebody|everybody) (is|are|was|has|have|leaves|stays|moves|asks|wants|does|becomes|lies|goes)\b)"
    R"(|\b(whom|whoever|nobody|somebody|everybody)\b|\b(tells?|telling|told)\b|\bspeaks? (of|for)\b)"
    R"(|What turned out)",
    std::regex::icase);
// The same in the name of a test.
const std::regex kStumblingName(
    R"(TEST\w*\(\w+, \w*(Who[A-Z]|Whoever|Nobody|Somebody|Everybody|Tells?[A-Z]|Told))");

/// The part of a line that people read: the texts and the comment of a source, all of a page.
std::string prose_of(const std::filesystem::path& file, const std::string& line) {
  if (file.extension() == ".md") return line;
  const std::size_t begin = std::min(line.find("//"), line.find('"'));
  return begin == std::string::npos ? std::string() : line.substr(begin);
}

/// This file has the phrases themselves.
bool has_prose(const std::filesystem::path& file) {
  return (file.extension() == ".md" || file.extension() == ".h" || file.extension() == ".cpp") &&
         file.filename() != "plain_english_test.cpp";
}

/// "file:line: text" of each line with such a phrase.
std::vector<std::string> stumbling_lines(const std::filesystem::path& file,
                                         const std::vector<std::string>& lines) {
  std::vector<std::string> found;
  for (std::size_t k = 0; k < lines.size(); ++k)
    if (std::regex_search(prose_of(file, lines[k]), kStumbling) ||
        std::regex_search(lines[k], kStumblingName))
      found.push_back(file.string() + ":" + std::to_string(k + 1) + ": " + lines[k]);
  return found;
}

TEST(PlainEnglish, IsWhatCommentsAndPagesHave) {
  std::vector<std::string> found;
  for (const std::filesystem::path& file : project_files()) {
    if (!has_prose(file)) continue;
    for (const std::string& line : stumbling_lines(file, lines_of(file))) found.push_back(line);
  }
  EXPECT_THAT(found, IsEmpty());
}

TEST(PlainEnglish, StumblingPhrasesAreSeen) {
  const std::vector<std::string> source = {"int a;  // who is asleep",   "/// Nobody asks.",
                                           "// The pair is told.",       "int nobody_is = 0;",
                                           "// It tells its name.",      "print(\"Somebody came\");",
                                           "TEST(Pairs, AreToldOnce) {", "TEST(Pairs, AreWhole) {"};
  EXPECT_THAT(stumbling_lines("a.h", source), SizeIs(6));
  EXPECT_THAT(stumbling_lines("a.md", {"Whoever moves it", "It speaks of one.", "the reporter"}), SizeIs(2));
}

}  // namespace
}  // namespace kerf::house
