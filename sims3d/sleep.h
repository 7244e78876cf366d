#pragma once

#include <cstdint>
#include <vector>

#include "core/base/ids.h"
#include "sims3d/ode_library.h"

namespace kerf {

/// When a body falls asleep, and when it wakes.
struct SleepRule {
  bool allowed = true;       ///< false: every moving object is simulated in every step
  double linear = 0.2;       ///< slower than this, in units a second, ...
  double angular = 0.4;      ///< ... and turning slower than this, in radians a second, ...
  std::uint32_t steps = 12;  ///< ... for so many steps: the body falls asleep
  double wake = 0.7;         ///< a sleeper wakes when a body approaches faster than this, in units a second
};

/// Decides body by body. ODE's own rule decides for whole heaps of touching bodies: one restless body would
/// keep a heap awake, and each arrival would wake it. Towards its waking neighbours a sleeper is a part of
/// the world that does not move.
class Sleep {
 public:
  explicit Sleep(const SleepRule& rule) : rule_(rule) {}

  /// Call it once a step for a body that moved: counts how long it has been slow, and puts it to sleep.
  void observe(ObjectId object, dBodyID body);
  /// Forgets how long the body has been slow, and wakes it.
  void wake(ObjectId object, dBodyID body);
  /// Whether a contact at this speed wakes a sleeper.
  [[nodiscard]] bool wakes(double approach_speed) const { return approach_speed > rule_.wake; }

 private:
  SleepRule rule_;
  std::vector<std::uint32_t> slow_steps_;
};

}  // namespace kerf
