#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "viz/debugger/window/window_layout.h"
#include "viz/draw/theme.h"

namespace kerf {

/// How a user wants the window: it is remembered from one start to the next.
struct WindowSettings {
  WindowLayout layout;
  double zoom = 1;  ///< of texts and all that is beside them
  ThemeName theme = ThemeName::light;

  /// The next larger size of texts, or the next smaller one.
  void zoom_by(bool larger);
  friend bool operator==(const WindowSettings&, const WindowSettings&) = default;
};

/// A text of a few lines that `parse_window_settings` reads back as the same settings.
std::string to_text(const WindowSettings& settings);
/// Throws std::invalid_argument that says which line is wrong, or that the end is missing.
WindowSettings parse_window_settings(std::string_view text);

/// The settings of a file; none if there is no file. Throws std::runtime_error that names the file, and what
/// is wrong with it.
std::optional<WindowSettings> load_window_settings(const std::filesystem::path& path);
/// An earlier file is there until this one is complete. Throws std::system_error with the path.
void save_window_settings(const std::filesystem::path& path, const WindowSettings& settings);

}  // namespace kerf
