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
  /// Makes the missing measurements and writes the page. Throws UsageError, Interrupted on request (the
  /// measurements so far are kept), and std::runtime_error if a file cannot be written.
  void run() const;

 private:
  CLI::App* command_;
  ReportTexts texts_;
};

}  // namespace kerf
