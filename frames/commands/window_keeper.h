#pragma once

#include <filesystem>
#include <optional>

#include "viz/debugger/debugger.h"

namespace kerf {

/// Throws UsageError if there is a file with something in it that `WindowKeeper` has not written.
void check_window_file(const std::filesystem::path& file);

/// Gives a debugger the window that the user left, and saves it when it has changed.
class WindowKeeper {
 public:
  /// Without a file nothing is read or written. What is wrong with the file is said in the window, which has
  /// the default layout then; the file stays until the user changes something, and for good if it is no
  /// window file. `theme` counts instead of the one in the file.
  WindowKeeper(Debugger& debugger, std::optional<std::filesystem::path> file, std::optional<ThemeName> theme);

  /// Saves what has changed, unless the mouse is dragging something.
  void keep();

 private:
  Debugger& debugger_;
  std::optional<std::filesystem::path> file_;
  WindowSettings kept_;
};

}  // namespace kerf
