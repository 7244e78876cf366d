#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "frames/sequence/render_request.h"
#include "viz/draw/theme.h"

namespace CLI {
class App;
}

namespace kerf {

class GlfwWindow;

/// `kerf debug`: examines a run, step by step, in a window or by a script.
class DebugCommand {
 public:
  explicit DebugCommand(CLI::App& program);
  [[nodiscard]] bool chosen() const;
  /// Throws UsageError, Interrupted, or std::runtime_error: a file cannot be read, there is no display, or a
  /// script's expectation does not hold.
  void run() const;

 private:
  /// No scene is named: a tour of one of ours begins.
  [[nodiscard]] bool is_tour() const;
  /// As the user named it.
  [[nodiscard]] std::string name() const;
  /// What is to be recorded, below `scratch` unless it is to be kept; nothing if a recording was given.
  [[nodiscard]] std::optional<RenderRequest> scene(const std::filesystem::path& scratch) const;
  /// Records it; the window, if there is one, shows how far that is.
  [[nodiscard]] std::filesystem::path record(const RenderRequest& request, GlfwWindow* window) const;

  [[nodiscard]] std::optional<double> scale() const;
  [[nodiscard]] std::optional<ThemeName> theme() const;
  [[nodiscard]] std::optional<std::filesystem::path> window_file() const;

  CLI::App* command_;
  RenderTexts texts_;
  std::string script_;
  std::string out_;
  std::string scale_;
  std::string theme_;
  std::string window_file_;
  std::vector<std::string> sessions_;
  bool headless_ = false;
};

}  // namespace kerf
