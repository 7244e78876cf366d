#pragma once

#include <chrono>
#include <cstdint>

#include "frames/support/countdown.h"
#include "frames/support/step_range.h"

namespace kerf {

/// One line on the terminal that is overwritten: frame, speed, time left. Silent unless standard error is a
/// terminal.
class Progress {
 public:
  explicit Progress(const StepRange& steps);

  /// `frames` are done and the simulation is at `step`.
  void update(std::uint32_t frames, std::uint32_t step);

 private:
  using Clock = std::chrono::steady_clock;

  StepRange steps_;
  ProgressLine line_;
  Stint stint_;
  Clock::time_point last_{};
};

}  // namespace kerf
