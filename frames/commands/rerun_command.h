#pragma once

#include <cstdint>
#include <string>

namespace CLI {
class App;
}

namespace kerf {

/// `kerf rerun`: the same boxes again, with another configuration of the tree, or another decision about one
/// operator.
class RerunCommand {
 public:
  explicit RerunCommand(CLI::App& program);
  [[nodiscard]] bool chosen() const;
  /// Throws UsageError, Interrupted, or std::runtime_error if a file cannot be read or written.
  void run() const;

 private:
  CLI::App* command_;
  std::string file_;
  std::string out_;
  std::string config_;
  std::string from_;
  std::string refuse_;
  std::string take_;
  bool overwrite_ = false;
};

}  // namespace kerf
