#pragma once

#include <array>
#include <string>

namespace CLI {
class App;
}

namespace kerf {

/// `kerf explain`: why two objects are a pair or none, what a node is, why an event happened,
/// what a query finds.
class ExplainCommand {
 public:
  explicit ExplainCommand(CLI::App& program);
  [[nodiscard]] bool chosen() const;
  /// Throws UsageError, or std::runtime_error if the recording cannot be read.
  void run() const;

 private:
  CLI::App* command_;
  std::string file_;
  std::string step_;
  std::string pair_;
  std::string node_;
  std::string event_;
  std::array<std::string, 4> asked_;  ///< by kind of query
};

}  // namespace kerf
