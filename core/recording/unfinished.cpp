#include "core/recording/unfinished.h"

#include <stdexcept>
#include <string>
#include <vector>

#include "core/files/part_file.h"

namespace kerf {

std::filesystem::path recording_at(const std::filesystem::path& path) {
  if (std::filesystem::exists(path)) return path;
  const std::vector<std::filesystem::path> parts = parts_of(path);
  if (parts.empty()) return path;
  if (parts.size() == 1) return parts.front();
  std::string names;
  for (const std::filesystem::path& part : parts) names += (names.empty() ? "" : ", ") + part.string();
  throw std::runtime_error("there is no recording " + path.string() +
                           ", but several that were not finished: " + names + "; name one of them");
}

}  // namespace kerf
