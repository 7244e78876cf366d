#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "frames/diff/frame_diff.h"

namespace kerf {

/// The result of a comparison of files or folders.
struct DiffResult {
  std::filesystem::path reference;
  std::filesystem::path test;
  DiffRules rules;
  std::vector<FrameDiff> frames;
  std::vector<std::string> notes;
  std::vector<std::string> faults;        ///< of the folders
  std::vector<ManifestDiff> manifests{};  ///< those that differ

  [[nodiscard]] std::size_t count_different() const;  ///< missing and extra frames included
  [[nodiscard]] std::size_t count_troubled() const;
  [[nodiscard]] bool is_usable() const { return faults.empty() && count_troubled() == 0; }
  [[nodiscard]] bool is_same() const { return is_usable() && count_different() == 0 && manifests.empty(); }
};

/// "4 of 20 frames differ", for the end of a list and of a page.
std::string summary_line(const DiffResult& result);
/// "frames.json: it is missing"
std::vector<std::string> manifest_lines(const DiffResult& result);
/// The findings, one frame after the other; the summary only if all are the same, since otherwise the error
/// message has it.
std::string to_text(const DiffResult& result);
std::string to_json(const DiffResult& result);

}  // namespace kerf
