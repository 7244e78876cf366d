#include <stdexcept>

#include "core/files/part_file.h"
#include "core/files/whole_file.h"
#include "viz/debugger/window/window_settings.h"

namespace kerf {

std::optional<WindowSettings> load_window_settings(const std::filesystem::path& path) {
  const auto text = read_whole_file_if_there(path);
  if (!text) return std::nullopt;
  try {
    return parse_window_settings(*text);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(path.string() + ": " + error.what());
  }
}

void save_window_settings(const std::filesystem::path& path, const WindowSettings& settings) {
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path());
  PartFile part(path);
  part.write(to_text(settings));
  part.keep();
}

}  // namespace kerf
