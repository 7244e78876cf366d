#include "viz/debugger/model/breakpoint.h"

namespace kerf {

std::optional<Stop> next_stop(Run& run, const std::vector<Breakpoint>& breakpoints, bool forwards,
                              const Run::Progress& progress) {
  std::optional<Stop> nearest;
  for (std::size_t k = 0; k < breakpoints.size(); ++k) {
    if (!breakpoints[k].enabled) continue;
    bool stopped = false;
    // What lies beyond the nearest so far is of no interest.
    const auto in_reach = [&](std::uint32_t step) {
      if (nearest && (forwards ? step > nearest->position.step : step < nearest->position.step)) return false;
      stopped = progress && !progress(step);
      return !stopped;
    };
    const auto found = run.search(breakpoints[k].condition, run.position(), forwards, in_reach);
    if (stopped) return std::nullopt;
    if (found && (!nearest || (forwards ? *found < nearest->position : nearest->position < *found)))
      nearest = Stop{*found, k};
  }
  return nearest;
}

}  // namespace kerf
