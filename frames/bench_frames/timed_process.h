#pragma once

#include <functional>

namespace kerf {

/// The time of a piece of work, all its processes together.
struct ProcessTimes {
  double wall = 0;  ///< seconds
  double cpu = 0;   ///< of all processors
};

/// Does the work in a process of its own, so that it inherits no GL, threads or memory. Throws
/// std::runtime_error if it fails; Interrupted after SIGINT or SIGTERM.
ProcessTimes run_timed(const std::function<void()>& work);

}  // namespace kerf
