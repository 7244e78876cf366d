#include "core/bsp/thread_chooser.h"

#include <algorithm>
#include <numeric>
#include <span>

namespace kerf {
namespace {

/// What sharing must gain: where it gains nothing, other work gets the cores.
constexpr double kGain = 0.95;
/// The share of all time that trials may take, and the limits of the steps from one to the next.
constexpr double kShareOfTrials = 0.02;
constexpr double kLeastWait = 64;
constexpr double kMostWait = 20000;

/// The middle one of an odd number of times.
double median(std::span<const double> seconds) {
  std::array<double, 8> sorted{};
  std::ranges::copy(seconds, sorted.begin());
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.begin() + static_cast<std::ptrdiff_t>(seconds.size()));
  return *middle;
}

/// Whether so many objects came or went that an earlier trial says nothing.
bool is_another_crowd(std::uint32_t objects, std::uint32_t before) {
  return objects / 2 > before || before / 2 > objects;
}

}  // namespace

bool ThreadChooser::choose(Mode mode, std::uint32_t objects, double seconds) {
  Trials& trials = trials_[static_cast<std::size_t>(mode)];
  if (objects < kFew || mode != last_) {
    last_ = mode;
    trials.runs = false;
    trials.wait = std::max(trials.wait, kStepsBefore);
  } else if (trials.runs) {
    trials.seconds[trials.done++] = seconds;
    if (trials.done == trials.seconds.size()) end_trial(trials, objects);
  } else if (trials.wait > 0 && !(trials.knows && is_another_crowd(objects, trials.objects))) {
    --trials.wait;
  } else {
    trials.runs = true;
    trials.done = 0;
  }
  if (objects < kFew) return false;
  if (trials.runs) return trials.done >= kTried;
  return trials.knows ? trials.is_shared_faster : objects >= kMany;
}

void ThreadChooser::end_trial(Trials& trials, std::uint32_t objects) {
  const std::span<const double> all = trials.seconds;
  const double alone = median(all.subspan(1, kTried - 1));
  const double shared = median(all.subspan(kTried + 1, kTried - 1));
  trials.is_shared_faster = shared < alone * kGain;
  const std::span<const double> slower = all.subspan(trials.is_shared_faster ? 0 : kTried, kTried);
  const double faster = trials.is_shared_faster ? shared : alone;
  const double lost =
      std::accumulate(slower.begin(), slower.end(), 0.0) - static_cast<double>(kTried) * faster;
  const double wait = faster > 0 ? lost / faster / kShareOfTrials : 0;
  trials.wait = static_cast<std::uint32_t>(std::clamp<double>(wait, kLeastWait, kMostWait));
  trials.runs = false;
  trials.knows = true;
  trials.objects = objects;
}

}  // namespace kerf
