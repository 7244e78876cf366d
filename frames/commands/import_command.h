#pragma once

#include <string>

namespace CLI {
class App;
}

namespace kerf {

/// `kerf import`: another engine's boxes, and its pairs, become a recording.
class ImportCommand {
 public:
  explicit ImportCommand(CLI::App& program);
  [[nodiscard]] bool chosen() const;
  /// Throws UsageError that names the line, or std::runtime_error if something cannot be read or written.
  void run() const;

 private:
  CLI::App* command_;
  std::string boxes_;
  std::string pairs_;
  std::string out_;
  std::string config_;
  std::string margin_;
  std::string ignore_;
  std::string objects_;
  std::string structure_;
  bool unite_ = false;
  bool strict_ = false;
  bool overwrite_ = false;
};

}  // namespace kerf
