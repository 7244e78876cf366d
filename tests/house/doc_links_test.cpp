#include <gmock/gmock.h>

#include <algorithm>

#include "tests/house/markdown.h"
#include "tests/house/project_files.h"

namespace kerf::house {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::filesystem::path> pages() {
  std::vector<std::filesystem::path> found = project_files();
  std::erase_if(found, [](const auto& file) { return file.extension() != ".md"; });
  return found;
}

bool is_there(const std::filesystem::path& from_root) {
  return std::filesystem::exists(std::filesystem::path(KERF_SOURCE_DIR) / from_root);
}

bool has_anchor(const std::filesystem::path& page, const std::string& anchor) {
  const std::vector<std::string> anchors = anchors_in(lines_of(page));
  return std::ranges::find(anchors, anchor) != anchors.end();
}

/// Whether "path#anchor", "path" or "#anchor" leads somewhere; the path is relative to `folder`.
bool leads_somewhere(const Reference& link, const std::filesystem::path& folder) {
  const std::size_t hash = link.target.find('#');
  const std::string path = link.target.substr(0, hash);
  const std::filesystem::path file = path.empty() ? link.from : (folder / path).lexically_normal();
  if (!is_there(file)) return false;
  return hash == std::string::npos || has_anchor(file, link.target.substr(hash + 1));
}

std::string to_string(const Reference& reference) {
  return reference.from.string() + ":" + std::to_string(reference.line) + ": " + reference.target;
}

TEST(DocLinks, LeadToFilesAndHeadings) {
  std::vector<std::string> broken;
  for (const std::filesystem::path& page : pages())
    for (const Reference& link : links_in(page, lines_of(page)))
      if (!leads_somewhere(link, page.parent_path())) broken.push_back(to_string(link));
  EXPECT_THAT(broken, IsEmpty());
}

TEST(DocLinks, NameFilesThatExist) {
  std::vector<std::string> missing;
  for (const std::filesystem::path& page : pages())
    for (const Reference& path : paths_in(page, lines_of(page)))
      if (!is_there(path.target)) missing.push_back(to_string(path));
  EXPECT_THAT(missing, IsEmpty());
}

TEST(DocLinks, HeadingsThatFilesNameExist) {
  std::vector<std::string> missing;
  for (const std::filesystem::path& file : project_files())
    for (const Reference& heading : named_headings_in(file, lines_of(file)))
      if (!leads_somewhere(heading, "docs")) missing.push_back(to_string(heading));
  EXPECT_THAT(missing, IsEmpty());
}

TEST(DocLinks, SeeThePages) {
  EXPECT_THAT(pages(), Contains(std::filesystem::path("README.md")));
  EXPECT_THAT(pages(), Contains(std::filesystem::path("docs/DESIGN.md")));
}

std::vector<std::string> targets(const std::vector<Reference>& references) {
  std::vector<std::string> found;
  for (const Reference& reference : references) found.push_back(reference.target);
  return found;
}

TEST(Markdown, LinksAndPathsOutsideOfCodeAreFound) {
  const std::vector<std::string> lines = {"See [a](docs/A.md#one), ![b](b.png) and [c](https://c.org).",
                                          "```", "[d](gone.md) `core/gone.h`", "```",
                                          "`core/tree/a.h`, `core/*.h`, `out/a.h` and `tests/a`"};
  EXPECT_THAT(targets(links_in("README.md", lines)), ElementsAre("docs/A.md#one", "b.png"));
  EXPECT_THAT(targets(paths_in("README.md", lines)), ElementsAre("core/tree/a.h", "tests/a"));
}

TEST(Markdown, HeadingsAreFoundByWordsAlsoAcrossLines) {
  const std::vector<std::string> lines = {"/// Exact (PAGE.md, \"Once\"), and only (PAGE.md, \"What a",
                                          "/// scene needs\").", "/// PAGE.md says more."};
  EXPECT_THAT(targets(named_headings_in("a.h", lines)),
              ElementsAre("PAGE.md#once", "PAGE.md#what-a-scene-needs"));
}

TEST(Markdown, AnchorsAreGitHubs) {
  EXPECT_THAT(anchors_in({"# Kerf: the design", "text", "### What if?", "```", "# no heading", "```"}),
              ElementsAre("kerf-the-design", "what-if"));
}

}  // namespace
}  // namespace kerf::house
