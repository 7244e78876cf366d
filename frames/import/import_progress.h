#pragma once

#include <chrono>
#include <string>
#include <utility>

#include "core/base/poll.h"
#include "frames/support/errors.h"
#include "frames/support/interrupt.h"
#include "frames/support/progress.h"

namespace kerf {

/// While it lives, an import is given up when it is interrupted, within a step too, and a line on the
/// terminal says where it is.
class ImportProgress {
 public:
  explicit ImportProgress(const InterruptGuard& interrupt)
      : interrupt_(interrupt), polling_([this] { look(); }) {}

  void at(std::string place) { place_ = std::move(place); }
  /// The line goes away.
  void end() const { line_.clear(); }

 private:
  using Clock = std::chrono::steady_clock;

  void look() {
    if (interrupt_.requested()) throw Interrupted("interrupted: nothing was imported");
    constexpr std::chrono::milliseconds kBetweenUpdates{100};
    if (!line_.is_shown() || Clock::now() - last_ < kBetweenUpdates) return;
    last_ = Clock::now();
    line_.show(place_ + "  " + std::to_string(static_cast<int>(stint_.seconds())) + " s");
  }

  const InterruptGuard& interrupt_;
  std::string place_ = "reading";
  ProgressLine line_;
  Stint stint_;
  Clock::time_point last_ = Clock::now();
  Polling polling_;
};

}  // namespace kerf
