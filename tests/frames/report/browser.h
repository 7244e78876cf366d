#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace kerf::test {

/// What headless Chromium, without a network, makes of a page.
struct Sight {
  struct Picture {
    double width = 0;
    double height = 0;
    std::size_t shapes = 0;  ///< elements of it that have a size
  };
  std::string trouble;                 ///< why there is nothing to see; empty: all went well
  std::vector<std::string> console;    ///< lines of the console
  std::vector<std::string> resources;  ///< addresses that the page asked for beside its own
  std::vector<Picture> pictures;       ///< of each svg element, as laid out
  bool fits = false;                   ///< no scrolling sideways
  std::vector<int> images;             ///< widths of the decoded pictures; 0: broken
  std::string answer;                  ///< of the script
};

/// Loads a copy of the page with a script in it that looks at what is there. `act`: the body of a function in
/// JavaScript that first does something with the page and may return a text.
Sight look_at(const std::filesystem::path& page, const std::string& act = "");

}  // namespace kerf::test
