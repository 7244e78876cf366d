#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace kerf::house {

/// Something that a page refers to.
struct Reference {
  std::filesystem::path from;  ///< the file in which it stands, from the root
  int line = 0;
  std::string target;
};

/// The targets of `[text](target)` and `![text](target)` outside of code blocks, addresses of the web left
/// out.
std::vector<Reference> links_in(const std::filesystem::path& page, const std::vector<std::string>& lines);

/// Paths of the project between backticks outside of code blocks: `core/tree/split.h`. Patterns with a star
/// or with braces are left out.
std::vector<Reference> paths_in(const std::filesystem::path& page, const std::vector<std::string>& lines);

/// Headings named in the words of any text: DESIGN.md, "Each pair once". The target is
/// "DESIGN.md#each-pair-once". A reference may go on in the next line of a comment.
std::vector<Reference> named_headings_in(const std::filesystem::path& file,
                                         const std::vector<std::string>& lines);

/// The anchors of a page's headings, as GitHub makes them.
std::vector<std::string> anchors_in(const std::vector<std::string>& lines);

}  // namespace kerf::house
