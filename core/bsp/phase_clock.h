#pragma once

#include <array>
#include <chrono>
#include <cstddef>

#include "core/trace/event.h"

namespace kerf {

/// How long each phase of the last step took.
class PhaseClock {
 public:
  /// Ends the phase that runs and begins another one.
  void begin(Phase phase) {
    end();
    phase_ = phase;
  }
  void end() {
    const auto now = std::chrono::steady_clock::now();
    seconds_[static_cast<std::size_t>(phase_)] = std::chrono::duration<double>(now - start_).count();
    start_ = now;
  }
  [[nodiscard]] const std::array<double, kPhaseCount>& seconds() const { return seconds_; }

 private:
  Phase phase_ = Phase::sweep;
  std::chrono::steady_clock::time_point start_;
  std::array<double, kPhaseCount> seconds_{};
};

}  // namespace kerf
