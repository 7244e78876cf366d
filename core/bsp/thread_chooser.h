#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/bsp/mode.h"

namespace kerf {

/// When the threads of a tree share the work of a step.
enum class Sharing : std::uint8_t {
  if_faster,  ///< where trials show that it takes less time, and never where there are few objects
  always,
};

/// Decides whether the work of the next step is shared. What sharing gains depends on the scene, on the mode,
/// and most of all on how soon a core sees what another one wrote, which no program knows of a machine. So
/// now and then some steps are done by one thread and some by all, and the faster way is kept. A trial of
/// what is much slower is repeated so late that all trials together take about a fiftieth of the time.
class ThreadChooser {
 public:
  /// A step of fewer objects is never shared: it takes less time than the wait for another thread. On two
  /// cores that see each other's writes late, two threads took 26 times as long with 100 objects, 3 times
  /// with 2,000 and 0.66 to 1.7 times with 64,000.
  static constexpr std::uint32_t kFew = 2000;
  /// So many objects share a step before the first trial.
  static constexpr std::uint32_t kMany = 50000;
  /// Steps from a change of mode or crowd to a trial.
  static constexpr std::uint32_t kStepsBefore = 3;
  /// The least number of steps from one trial to the next.
  static constexpr std::uint32_t kLeastWait = 64;
  static constexpr std::size_t kTrialSteps = 10;

  /// Call it at the end of each step, with its mode and time. Returns whether the next step is shared.
  bool choose(Mode mode, std::uint32_t objects, double seconds);

 private:
  struct Trials {
    std::array<double, kTrialSteps> seconds{};  ///< of the steps of the trial
    std::size_t done = 0;                       ///< number of them
    bool runs = false;
    bool knows = false;
    bool is_shared_faster = false;
    double faster = 0;                  ///< seconds of a step in the last trial, the faster way
    std::uint32_t objects = 0;          ///< when it ended
    std::uint32_t since = kLeastWait;   ///< steps since then
    std::uint32_t wait = kStepsBefore;  ///< steps until the next one
    std::uint32_t odd = 0;              ///< steps in a row that took another time than those of the trial
  };
  static void interrupt(Trials& trials);
  static void wait_for_trial(Trials& trials, std::uint32_t objects, double seconds);
  static void end_trial(Trials& trials, std::uint32_t objects);

  std::array<Trials, kModeCount> trials_;
  Mode last_ = Mode::ordered;
};

}  // namespace kerf
