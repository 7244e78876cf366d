#pragma once

#include <string>

namespace CLI {
class App;
}

namespace kerf {

/// `kerf advise`: which broad phase is the fastest on a recording.
class AdviseCommand {
 public:
  explicit AdviseCommand(CLI::App& program);
  [[nodiscard]] bool chosen() const;
  /// Measures and prints. Throws UsageError, Interrupted on request, and std::runtime_error if the recording
  /// cannot be read or a result cannot be written.
  void run() const;

 private:
  CLI::App* command_;
  std::string file_;
  std::string steps_;
  std::string broad_phases_;
  std::string rounds_;
  std::string patience_;
  std::string json_;
  std::string plot_;
  bool overwrite_ = false;
};

}  // namespace kerf
