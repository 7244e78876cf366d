#include "core/bsp/thread_chooser.h"

#include <algorithm>
#include <limits>

namespace kerf {
namespace {

/// What sharing must gain: where it gains nothing, other work gets the cores.
constexpr double kGain = 0.95;
/// The share of all time that trials may take.
constexpr double kShareOfTrials = 0.02;
constexpr double kMostWait = 20000;
/// A step of another scene takes so many times as long, or as little, as those of the last trial.
constexpr double kAnotherTime = 4;
/// So many of them in a row are no accident.
constexpr std::uint32_t kOddSteps = 8;

/// The steps of a trial that are shared: those in the middle, so that neither way gains by times that fall.
constexpr std::size_t kFirstShared = 3;
constexpr std::size_t kEndShared = 7;
constexpr bool is_shared(std::size_t step) { return step >= kFirstShared && step < kEndShared; }

/// The median of the steps of one way; the first one after a change of the way does not count.
double median(const std::array<double, ThreadChooser::kTrialSteps>& seconds, bool shared) {
  std::array<double, ThreadChooser::kTrialSteps> counting;
  counting.fill(std::numeric_limits<double>::infinity());  // behind those that count
  std::size_t count = 0;
  for (std::size_t step = 1; step < seconds.size(); ++step)
    if (is_shared(step) == shared && is_shared(step - 1) == shared) counting[count++] = seconds[step];
  std::ranges::sort(counting);
  return (counting[(count - 1) / 2] + counting[count / 2]) / 2;
}

/// Whether so many objects came or went that an earlier trial says nothing.
bool is_another_crowd(std::uint32_t objects, std::uint32_t before) {
  return objects / 2 > before || before / 2 > objects;
}

}  // namespace

bool ThreadChooser::choose(Mode mode, std::uint32_t objects, double seconds) {
  Trials& trials = trials_[static_cast<std::size_t>(mode)];
  if (objects < kFew || mode != last_) {
    interrupt(trials);
  } else if (trials.runs) {
    trials.seconds[trials.done++] = seconds;
    if (trials.done == kTrialSteps) end_trial(trials, objects);
  } else {
    wait_for_trial(trials, objects, seconds);
  }
  last_ = mode;
  if (objects < kFew) return false;
  if (trials.runs) return is_shared(trials.done);
  return trials.knows ? trials.is_shared_faster : objects >= kMany;
}

/// A trial that was interrupted while it shared steps has cost what one costs that ends.
void ThreadChooser::interrupt(Trials& trials) {
  const bool was_costly = trials.runs && trials.done > kFirstShared;
  trials.wait = std::max(trials.wait, was_costly ? kLeastWait : kStepsBefore);
  trials.runs = false;
  trials.odd = 0;
}

void ThreadChooser::wait_for_trial(Trials& trials, std::uint32_t objects, double seconds) {
  ++trials.since;
  const bool is_odd = seconds > kAnotherTime * trials.faster || kAnotherTime * seconds < trials.faster;
  trials.odd = trials.knows && is_odd ? trials.odd + 1 : 0;
  const bool is_another = trials.odd >= kOddSteps || is_another_crowd(objects, trials.objects);
  if (trials.knows && is_another && trials.since >= kLeastWait)
    trials.wait = std::min(trials.wait, kStepsBefore);
  if (trials.wait > 0) {
    --trials.wait;
  } else {
    trials.runs = true;
    trials.done = 0;
  }
}

void ThreadChooser::end_trial(Trials& trials, std::uint32_t objects) {
  const double alone = median(trials.seconds, false);
  const double shared = median(trials.seconds, true);
  trials.is_shared_faster = shared < alone * kGain;
  trials.faster = trials.is_shared_faster ? shared : alone;
  const double slower = trials.is_shared_faster ? alone : shared;
  const double lost = static_cast<double>(kTrialSteps) / 2 * (slower - trials.faster);
  const double wait = trials.faster > 0 ? lost / trials.faster / kShareOfTrials : 0;
  trials.wait = static_cast<std::uint32_t>(std::clamp<double>(wait, kLeastWait, kMostWait));
  trials.runs = false;
  trials.knows = true;
  trials.objects = objects;
  trials.since = trials.odd = 0;
}

}  // namespace kerf
