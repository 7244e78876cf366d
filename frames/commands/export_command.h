#pragma once

#include <string>

namespace CLI {
class App;
}

namespace kerf {

/// `kerf export`: a recording for other programs.
class ExportCommand {
 public:
  explicit ExportCommand(CLI::App& program);
  [[nodiscard]] bool chosen() const;
  /// Throws UsageError, or std::runtime_error if something cannot be read or written.
  void run() const;

 private:
  CLI::App* command_;
  std::string file_;
  std::string out_;
  bool chrome_trace_ = false;
  bool csv_ = false;
  bool boxes_ = false;
  bool pairs_ = false;
  bool overwrite_ = false;
};

}  // namespace kerf
