#pragma once

#include <array>
#include <chrono>
#include <cstddef>

#include "core/trace/event.h"

namespace kerf {

/// How long each phase of the last step took. It is off until it is set on: to read the time six times a step
/// takes as long as all else in a step of a few objects at rest.
class PhaseClock {
 public:
  [[nodiscard]] bool is_on() const { return is_on_; }
  void set_on(bool on) {
    is_on_ = on;
    seconds_ = {};
    start_ = std::chrono::steady_clock::now();
  }
  /// Ends the phase that runs and begins another one.
  void begin(Phase phase) {
    end();
    phase_ = phase;
  }
  void end() {
    if (!is_on_) return;
    const auto now = std::chrono::steady_clock::now();
    seconds_[static_cast<std::size_t>(phase_)] = std::chrono::duration<double>(now - start_).count();
    start_ = now;
  }
  [[nodiscard]] const std::array<double, kPhaseCount>& seconds() const { return seconds_; }

 private:
  bool is_on_ = false;
  Phase phase_ = Phase::sweep;
  std::chrono::steady_clock::time_point start_;
  std::array<double, kPhaseCount> seconds_{};
};

}  // namespace kerf
