#pragma once

#include <cstddef>
#include <string>

namespace CLI {
class App;
}

namespace kerf {

/// `kerf lint`: operators of a recording that undo each other or never act, or faults of another engine's
/// structure.
class LintCommand {
 public:
  explicit LintCommand(CLI::App& program);
  [[nodiscard]] bool chosen() const;
  /// Throws UsageError, or std::runtime_error if something was found or the file cannot be read.
  void run() const;

 private:
  /// How many were found and printed.
  [[nodiscard]] std::size_t lint_operators() const;
  [[nodiscard]] std::size_t lint_structure() const;

  CLI::App* command_;
  std::string file_;
  std::string within_;
  std::string depth_;
  std::string overlap_;
  std::string margin_;
  bool structure_ = false;
};

}  // namespace kerf
