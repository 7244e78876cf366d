#pragma once

#include <string>

namespace CLI {
class App;
}

namespace kerf {

/// `kerf lint`: operators of a recording that undo each other or never act.
class LintCommand {
 public:
  explicit LintCommand(CLI::App& program);
  [[nodiscard]] bool chosen() const;
  /// Throws UsageError, or std::runtime_error if something was found or the file cannot be read.
  void run() const;

 private:
  CLI::App* command_;
  std::string file_;
  std::string within_;
};

}  // namespace kerf
