#pragma once

#include <string>

namespace CLI {
class App;
}

namespace kerf {

/// `kerf experiment`: the paper's figures 12 and 13 and its claims, from simulations run here.
class ExperimentCommand {
 public:
  explicit ExperimentCommand(CLI::App& program);
  [[nodiscard]] bool chosen() const;
  /// Throws UsageError, Interrupted, or std::runtime_error.
  void run() const;

 private:
  CLI::App* command_;
  std::string steps_;
  std::string seeds_;
  std::string repeats_;
  std::string objects_;
  std::string seed_;
  std::string out_;
  std::string shard_;
  bool full_ = false;
  bool related_ = false;
  bool overwrite_ = false;
};

}  // namespace kerf
