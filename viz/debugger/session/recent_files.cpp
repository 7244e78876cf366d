#include "viz/debugger/session/recent_files.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <system_error>

#include "core/files/part_file.h"

namespace kerf {
namespace {

std::filesystem::path folder_in(const char* variable) {
  const char* const value = std::getenv(variable);
  return value == nullptr ? "" : value;
}

/// Folders first, then recordings.
std::size_t rank(const std::filesystem::directory_entry& entry) {
  std::error_code error;
  if (entry.is_directory(error)) return 0;
  return entry.path().extension() == ".kerf" ? 1 : 2;
}

}  // namespace

std::filesystem::path config_folder() {
  if (const auto folder = folder_in("XDG_CONFIG_HOME"); folder.is_absolute()) return folder / "kerf";
  const auto home = folder_in("HOME");
  return home.is_absolute() ? home / ".config" / "kerf" : std::filesystem::path();
}

RecentFiles::RecentFiles(const std::filesystem::path& folder)
    : file_(folder.empty() ? folder : folder / "recent") {
  std::ifstream lines(file_);
  for (std::string line; files_.size() < kMostRecent && std::getline(lines, line);)
    if (!line.empty()) files_.push_back(line);
}

void RecentFiles::add(const std::filesystem::path& recording) {
  std::error_code error;
  const std::string file = std::filesystem::absolute(recording, error).lexically_normal().string();
  if (error || file.find('\n') != std::string::npos) return;
  std::erase(files_, file);
  files_.insert(files_.begin(), file);
  files_.resize(std::min(files_.size(), kMostRecent));
  if (file_.empty()) return;
  std::string text;
  for (const std::string& line : files_) text += line + "\n";
  try {
    std::filesystem::create_directories(file_.parent_path());
    PartFile part(file_);
    part.write(text);
    part.keep();
  } catch (const std::system_error&) {
    file_.clear();
  }
}

std::filesystem::path path_of(const std::string& typed) {
  const auto home = folder_in("HOME");
  if (home.empty() || (typed != "~" && !typed.starts_with("~/"))) return typed;
  return home.string() + typed.substr(1);
}

std::vector<std::string> complete_path(const std::string& typed) {
  const std::size_t name_at = typed.rfind('/') == std::string::npos ? 0 : typed.rfind('/') + 1;
  const std::string folder = typed.substr(0, name_at);
  const std::string begin = typed.substr(name_at);
  std::array<std::vector<std::string>, 3> found;
  std::error_code error;
  for (std::filesystem::directory_iterator it(folder.empty() ? "." : path_of(folder), error), end;
       !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (!name.starts_with(begin) || (begin.empty() && name.front() == '.')) continue;
    const std::size_t of = rank(*it);
    found[of].push_back(folder + name + (of == 0 ? "/" : ""));
  }
  std::vector<std::string> all;
  for (std::vector<std::string>& part : found) {
    std::ranges::sort(part);
    std::ranges::move(part, std::back_inserter(all));
  }
  return all;
}

}  // namespace kerf
