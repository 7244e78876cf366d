#pragma once

#include <string>

namespace CLI {
class App;
}

namespace kerf {

/// `kerf step`: goes to the next or the last moment of a recording at which a condition holds.
class StepCommand {
 public:
  explicit StepCommand(CLI::App& program);
  [[nodiscard]] bool chosen() const;
  /// Throws UsageError, Interrupted, or std::runtime_error if there is no such moment.
  void run() const;

 private:
  CLI::App* command_;
  std::string file_;
  std::string to_;
  std::string from_;
  std::string hits_;
  std::string picture_;
  bool reverse_ = false;
  bool overwrite_ = false;
};

}  // namespace kerf
