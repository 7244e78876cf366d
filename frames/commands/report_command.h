#pragma once

#include "frames/report/report_request.h"

namespace CLI {
class App;
}

namespace kerf {

/// `kerf report`: one page of speed against error.
class ReportCommand {
 public:
  explicit ReportCommand(CLI::App& program);
  [[nodiscard]] bool chosen() const;
  /// Measures what is not yet measured and writes the page. Throws UsageError, Interrupted when asked to stop
  /// (what was measured is kept), and std::runtime_error if a file cannot be written.
  void run() const;

 private:
  CLI::App* command_;
  ReportTexts texts_;
};

}  // namespace kerf
