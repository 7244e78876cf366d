#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "core/files/part_file.h"
#include "viz/debugger/window/window_settings.h"

namespace kerf {
namespace {

/// A folder that a variable of the environment names; the standard wants relative ones to be ignored.
std::optional<std::filesystem::path> folder_named_by(const char* variable) {
  const char* const text = std::getenv(variable);
  if (text == nullptr || !std::filesystem::path(text).is_absolute()) return std::nullopt;
  return text;
}

}  // namespace

std::optional<std::filesystem::path> usual_window_file() {
  auto folder = folder_named_by("XDG_CONFIG_HOME");
  if (!folder)
    if (const auto home = folder_named_by("HOME")) folder = *home / ".config";
  if (!folder) return std::nullopt;
  return *folder / "kerf" / "debug-window";
}

std::optional<WindowSettings> load_window_settings(const std::filesystem::path& path) {
  std::error_code unknown;
  if (!std::filesystem::exists(path, unknown) && !unknown) return std::nullopt;
  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file.good() && !file.eof()) throw std::runtime_error(path.string() + " cannot be read");
  try {
    return parse_window_settings(text);
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
