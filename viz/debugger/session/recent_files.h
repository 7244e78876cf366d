#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace kerf {

inline constexpr std::size_t kMostRecent = 10;

/// What the debugger remembers for a user: $XDG_CONFIG_HOME/kerf, else ~/.config/kerf; empty if neither is an
/// absolute path.
std::filesystem::path config_folder();

/// The recordings that were opened lately, the latest first: a line each in the file `recent` of a folder.
class RecentFiles {
 public:
  /// Remembers them in no file.
  RecentFiles() = default;
  /// Of the folder, as far as it can be read.
  explicit RecentFiles(const std::filesystem::path& folder);

  /// The latest from now on. A folder that cannot be written is no error: it is forgotten with the program.
  void add(const std::filesystem::path& recording);
  [[nodiscard]] const std::vector<std::string>& files() const { return files_; }

 private:
  std::filesystem::path file_;
  std::vector<std::string> files_;
};

/// What is being typed as a path, and what there is to complete it: folders, which end with a slash, then
/// recordings (*.kerf), then other files, each by name. Hidden ones only if their first letter was typed.
std::vector<std::string> complete_path(const std::string& typed);

/// With ~ as the user's folder.
std::filesystem::path path_of(const std::string& typed);

}  // namespace kerf
