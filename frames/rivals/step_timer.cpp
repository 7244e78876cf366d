#include "frames/rivals/step_timer.h"

#include <algorithm>
#include <ctime>

namespace kerf {
namespace {

std::uint64_t now(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<std::uint64_t>(time.tv_sec) * 1'000'000'000U + static_cast<std::uint64_t>(time.tv_nsec);
}

}  // namespace

// The processor clock is read first and last, so that only its own time includes the cost of reading.
StepTimer::StepTimer(bool one_thread)
    : one_thread_(one_thread),
      processor_(one_thread ? now(CLOCK_THREAD_CPUTIME_ID) : 0),
      wall_(now(CLOCK_MONOTONIC)) {}

std::uint64_t StepTimer::nanoseconds() const {
  const std::uint64_t wall = now(CLOCK_MONOTONIC) - wall_;
  return one_thread_ ? std::min(wall, now(CLOCK_THREAD_CPUTIME_ID) - processor_) : wall;
}

}  // namespace kerf
