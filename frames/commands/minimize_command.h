#pragma once

#include <string>

namespace CLI {
class App;
}

namespace kerf {

/// `kerf minimize`: the smallest run in which a condition still holds.
class MinimizeCommand {
 public:
  explicit MinimizeCommand(CLI::App& program);
  [[nodiscard]] bool chosen() const;
  /// Throws UsageError, Interrupted, or std::runtime_error if the condition never holds or a file cannot be
  /// written.
  void run() const;

 private:
  CLI::App* command_;
  std::string file_;
  std::string when_;
  std::string out_;
  bool overwrite_ = false;
};

}  // namespace kerf
