#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/bsp/mode.h"

namespace kerf {

/// When the threads of a tree share the work of a step.
enum class Sharing : std::uint8_t {
  if_faster,  ///< as steps of either kind took, and never where there are few objects
  always,
};

/// Decides whether the work of the next step is shared. What sharing gains depends on the scene, on the mode,
/// and most of all on how soon a core sees what another one wrote, which no program knows of a machine. So
/// now and then some steps are done by one thread and some by all, and the faster way is gone on with. A
/// trial of what is much slower is repeated so late that all trials together take a fiftieth of the time.
class ThreadChooser {
 public:
  /// Fewer objects never share a step, which is shorter than the wait for another thread. On two cores that
  /// see each other's writes late, two threads took 26 times as long with 100 objects, 3 times with 2,000 and
  /// 0.66 to 1.7 times with 64,000.
  static constexpr std::uint32_t kFew = 2000;
  /// So many objects share a step before the first trial.
  static constexpr std::uint32_t kMany = 50000;
  /// Steps from a change of mode to a trial.
  static constexpr std::uint32_t kStepsBefore = 3;

  /// Call it at the end of each step, with its mode and time. Returns whether the next step is shared.
  bool choose(Mode mode, std::uint32_t objects, double seconds);

 private:
  static constexpr std::size_t kTried =
      4;  ///< steps of each kind in a trial; the first of them does not count

  struct Trials {
    std::array<double, 2 * kTried> seconds{};  ///< of the trial's steps: alone, then shared
    std::size_t done = 0;                      ///< of them
    bool runs = false;
    bool knows = false;
    bool is_shared_faster = false;
    std::uint32_t wait = 0;     ///< steps until the next trial
    std::uint32_t objects = 0;  ///< when the last one ended
  };
  void end_trial(Trials& trials, std::uint32_t objects);

  std::array<Trials, kModeCount> trials_;
  Mode last_ = Mode::ordered;
};

}  // namespace kerf
