#pragma once

#include <string>

namespace CLI {
class App;
}

namespace kerf {

/// `kerf verify`: replays a recording and compares it with what was recorded, and its pairs with the oracle.
class VerifyCommand {
 public:
  explicit VerifyCommand(CLI::App& program);
  [[nodiscard]] bool chosen() const;
  /// Throws UsageError, Interrupted, or std::runtime_error if the recording cannot be read or does not hold.
  void run() const;

 private:
  CLI::App* command_;
  std::string file_;
  std::string oracle_every_;
  bool timings_ = false;
};

}  // namespace kerf
