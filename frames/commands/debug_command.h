#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "frames/sequence/render_request.h"

namespace CLI {
class App;
}

namespace kerf {

/// `kerf debug`: examines a run, step by step, in a window or by a script.
class DebugCommand {
 public:
  explicit DebugCommand(CLI::App& program);
  [[nodiscard]] bool chosen() const;
  /// Throws UsageError, Interrupted, or std::runtime_error: a file cannot be read, there is no display, or a
  /// script's expectation does not hold.
  void run() const;

 private:
  /// The given recording, or one made of the scene, below `scratch` unless it is to be kept.
  /// No scene is named: a tour of one of ours begins.
  [[nodiscard]] bool is_tour() const;
  [[nodiscard]] std::filesystem::path recording(const std::filesystem::path& scratch) const;

  CLI::App* command_;
  RenderTexts texts_;
  std::string script_;
  std::string out_;
  std::vector<std::string> sessions_;
  bool headless_ = false;
};

}  // namespace kerf
