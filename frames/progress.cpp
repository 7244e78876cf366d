#include "frames/progress.h"

#include <unistd.h>

#include <cstdio>

namespace kerf {
namespace {

constexpr std::chrono::milliseconds kBetweenUpdates{100};
constexpr const char* kEraseLine = "\r\033[K";

}  // namespace

Progress::Progress(const StepRange& steps) : steps_(steps), shown_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (shown_) std::fputs(kEraseLine, stderr);
}

void Progress::update(std::uint32_t frames, std::uint32_t step) {
  const Clock::time_point now = Clock::now();
  if (!shown_ || now - last_ < kBetweenUpdates) return;
  last_ = now;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double left = seconds * (steps_.last - step) / step;
  std::fprintf(stderr, "%sframe %u/%u  step %u/%u  %.1f frames/s  %d:%02d left", kEraseLine, frames,
               steps_.frames(), step, steps_.last, frames / seconds, static_cast<int>(left) / 60,
               static_cast<int>(left) % 60);
  std::fflush(stderr);
}

}  // namespace kerf
