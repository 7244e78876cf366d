#pragma once

#include <string>

namespace CLI {
class App;
}

namespace kerf {

/// `kerf compare`: the first difference between two recordings.
class CompareCommand {
 public:
  explicit CompareCommand(CLI::App& program);
  [[nodiscard]] bool chosen() const;
  /// Throws UsageError, or std::runtime_error if they differ or cannot be read.
  void run() const;

 private:
  CLI::App* command_;
  std::string a_;
  std::string b_;
  bool json_ = false;
};

}  // namespace kerf
