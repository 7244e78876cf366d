#include "frames/support/progress.h"

#include "frames/support/printed.h"

namespace kerf {
namespace {

constexpr std::chrono::milliseconds kBetweenUpdates{100};

}  // namespace

Progress::Progress(const StepRange& steps) : steps_(steps) {}

void Progress::update(std::uint32_t frames, std::uint32_t step) {
  const Clock::time_point now = Clock::now();
  if (!line_.is_shown() || now - last_ < kBetweenUpdates) return;
  last_ = now;
  line_.show(printed("frame %u/%u  step %u/%u  %.1f frames/s  %s", frames, steps_.frames(), step, steps_.last,
                     frames / stint_.seconds(), stint_.left(step, steps_.last).c_str()));
}

}  // namespace kerf
