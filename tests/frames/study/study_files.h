#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "frames/support/errors.h"
#include "tests/frames/program.h"

namespace kerf::test {

/// A folder with a study of 24 small cells, and runs of `kerf study` in it.
class StudyFolder {
 public:
  static constexpr const char* kSmall = R"({"matrices": [
    {"motions": ["falling", "brownian"], "dimensions": [2], "objects": [40, 60], "seeds": [1, 2],
     "broad_phases": ["kerf", "kerf-paper", "columns"], "warm_up": 2, "steps": 3,
     "measure": ["times", "counts", "errors"]}]})";

  explicit StudyFolder(const std::string& text = kSmall) { write("study.json", text); }

  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path() / name; }
  void write(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }

  /// `kerf study study.json` with these arguments, in which "@" is the folder.
  [[nodiscard]] RunOutcome run(const std::vector<std::string>& more) const {
    return run_kerf(arguments(more));
  }
  [[nodiscard]] std::vector<std::string> arguments(const std::vector<std::string>& more) const {
    std::vector<std::string> words{"study", path("study.json")};
    for (const std::string& word : more) words.push_back(word.starts_with('@') ? path(word.substr(1)) : word);
    return words;
  }
  /// The names of the files of cells in a folder.
  [[nodiscard]] std::vector<std::string> cells(const std::string& folder) const {
    std::vector<std::string> found;
    for (const std::string& file : files_in(path(folder)))
      if (file.ends_with(".json")) found.push_back(file);
    return found;
  }

 private:
  TemporaryFolder folder_;
};

/// A study of frames of a recorded run of 40 steps.
class FramesStudy : public StudyFolder {
 public:
  FramesStudy(const std::string& steps, const std::string& parts)
      : StudyFolder(R"({"matrices": [{"recording": "run.kerf", "size": "96x64", "steps": ")" + steps +
                    R"(", "parts": )" + parts + "}]}") {
    EXPECT_EQ(run_kerf({"record", "pile", "--steps", "40", "--objects", "30", "-o", path("run.kerf")}).exit,
              kExitHolds);
  }
};

/// The columns of a joined table before the first time, line by line.
inline std::string counts_of(const std::string& csv) {
  const std::string heading = csv.substr(0, csv.find('\n'));
  const std::size_t end = heading.find(",time_");
  const auto columns = std::count(heading.begin(), heading.begin() + static_cast<std::ptrdiff_t>(end), ',');
  std::string counts;
  std::ptrdiff_t seen = 0;
  for (const char c : csv) {
    if (c == '\n') seen = -1;
    if (c == ',' || c == '\n') ++seen;
    if (seen <= columns) counts += c;
  }
  return counts;
}

}  // namespace kerf::test
