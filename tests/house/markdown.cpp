#include "tests/house/markdown.h"

#include <cctype>
#include <regex>

namespace kerf::house {
namespace {

/// Calls visit(number, line) for each line outside of code blocks.
template <class Visit>
void visit_prose(const std::vector<std::string>& lines, Visit visit) {
  bool in_code = false;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (lines[k].starts_with("```"))
      in_code = !in_code;
    else if (!in_code)
      visit(static_cast<int>(k) + 1, lines[k]);
  }
}

/// What the expression's first group matches in the prose of a page.
std::vector<Reference> found_in(const std::filesystem::path& page, const std::vector<std::string>& lines,
                                const std::regex& expression) {
  std::vector<Reference> found;
  visit_prose(lines, [&](int number, const std::string& line) {
    for (std::sregex_iterator match(line.begin(), line.end(), expression), end; match != end; ++match)
      found.push_back({page, number, (*match)[1]});
  });
  return found;
}

std::string anchor_of(std::string_view heading) {
  std::string anchor;
  for (const char c : heading) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_')
      anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (c == ' ')
      anchor += '-';
  }
  return anchor;
}

/// A line without the mark of a comment or the spaces at its begin.
std::string words_of(const std::string& line) {
  const std::size_t begin = line.find_first_not_of(" \t/#");
  return begin == std::string::npos ? std::string() : line.substr(begin);
}

}  // namespace

std::vector<Reference> links_in(const std::filesystem::path& page, const std::vector<std::string>& lines) {
  static const std::regex kLink(R"(\]\(((?!https?:|mailto:)[^)\s]+)\))");
  return found_in(page, lines, kLink);
}

std::vector<Reference> paths_in(const std::filesystem::path& page, const std::vector<std::string>& lines) {
  static const std::regex kPath("`((?:core|viz|sims2d|sims3d|frames|tests|docs|cmake)/[\\w./-]+)`");
  return found_in(page, lines, kPath);
}

std::vector<Reference> named_headings_in(const std::filesystem::path& file,
                                         const std::vector<std::string>& lines) {
  static const std::regex kNamed("([A-Z_]+\\.md), \"([^\"]{1,80})\"");
  std::vector<Reference> found;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::string next = k + 1 < lines.size() ? words_of(lines[k + 1]) : std::string();
    const std::string both = lines[k] + ' ' + next;
    for (std::sregex_iterator match(both.begin(), both.end(), kNamed), end; match != end; ++match)
      if (static_cast<std::size_t>(match->position()) < lines[k].size())
        found.push_back(
            {file, static_cast<int>(k) + 1, (*match)[1].str() + '#' + anchor_of((*match)[2].str())});
  }
  return found;
}

std::vector<std::string> anchors_in(const std::vector<std::string>& lines) {
  std::vector<std::string> anchors;
  visit_prose(lines, [&](int, const std::string& line) {
    if (line.starts_with('#')) anchors.push_back(anchor_of(words_of(line)));
  });
  return anchors;
}

}  // namespace kerf::house
