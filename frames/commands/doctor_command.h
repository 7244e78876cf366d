#pragma once

#include <string>

namespace CLI {
class App;
}

namespace kerf {

/// `kerf doctor`: what is there on this machine, and what to do about what is not.
class DoctorCommand {
 public:
  explicit DoctorCommand(CLI::App& program);

  [[nodiscard]] bool chosen() const;
  /// Throws UsageError, DoesNotHold if something is missing, std::runtime_error if standard output cannot be
  /// written.
  void run() const;

 private:
  CLI::App* command_;
  std::string room_;
  bool json_ = false;
};

}  // namespace kerf
