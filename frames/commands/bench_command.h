#pragma once

#include "frames/bench/bench_request.h"

namespace CLI {
class App;
}

namespace kerf {

/// `kerf bench`: the times of broad phases, ours and others', on the same boxes.
class BenchCommand {
 public:
  explicit BenchCommand(CLI::App& program);
  [[nodiscard]] bool chosen() const;
  /// Measures and prints. Throws UsageError, Interrupted on request (the measurements so far are written),
  /// and std::runtime_error if the result cannot be written.
  void run() const;

 private:
  CLI::App* command_;
  BenchTexts texts_;
  bool overwrite_ = false;
};

}  // namespace kerf
