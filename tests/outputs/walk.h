#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/outputs/scenario.h"

namespace kerf::faults {

/// What happens to the n-th call that writes.
enum class Fault { input_output_error, no_space, kill };

/// What was tried of a scenario, and what was wrong.
struct WalkResult {
  std::uint64_t calls = 0;  ///< that a run makes
  int errors = 0;           ///< runs in which a call failed with EIO
  int full = 0;             ///< with ENOSPC
  int kills = 0;
  int unharmed = 0;  ///< of all these, runs that succeeded
  std::vector<std::string> findings;
};

/// Runs the scenario once as it is, then with a fault of each kind at up to `points` calls, evenly chosen
/// among all, the first and the last among them. After each run every output must be the earlier one or the
/// new one, whole; inputs must be as they were; a run that succeeds must have made all; and one that
/// ended by itself must leave no part, but for a recording that has steps and that it names. Throws
/// std::runtime_error if the run fails without a fault.
WalkResult walk(const Scenario& scenario, std::uint64_t points);

}  // namespace kerf::faults
