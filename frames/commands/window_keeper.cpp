#include "frames/commands/window_keeper.h"

#include <exception>
#include <string>
#include <utility>

#include "core/files/whole_file.h"
#include "frames/support/errors.h"

namespace kerf {

void check_window_file(const std::filesystem::path& file) {
  const std::string ours = to_text(WindowSettings{});
  const auto text = read_whole_file_if_there(file);
  if (text && !text->empty() && !text->starts_with(ours.substr(0, ours.find('\n') + 1)))
    throw UsageError(file.string() + " is no window file and is not replaced; choose another name");
}

WindowKeeper::WindowKeeper(Debugger& debugger, std::optional<std::filesystem::path> file,
                           std::optional<ThemeName> theme)
    : debugger_(debugger), file_(std::move(file)) {
  WindowSettings& window = debugger.window();
  bool is_damaged = false;
  try {
    if (file_)
      if (const auto settings = load_window_settings(*file_)) window = *settings;
  } catch (const std::exception& error) {
    is_damaged = true;
    debugger.report(std::string("the window has its default layout: ") + error.what(), true);
  }
  kept_ = window;
  if (theme) window.theme = *theme;
  if (is_damaged) kept_ = window;
}

void WindowKeeper::keep() {
  if (!file_ || debugger_.window() == kept_ || debugger_.is_dragging()) return;
  kept_ = debugger_.window();
  try {
    check_window_file(*file_);
    save_window_settings(*file_, kept_);
  } catch (const std::exception& error) {
    debugger_.report(std::string("the layout cannot be remembered: ") + error.what(), true);
  }
}

}  // namespace kerf
