#include "viz/debugger/model/breakpoint.h"

namespace kerf {
namespace {

/// Keeps the nearest of several moments.
class NearestMoment {
 public:
  NearestMoment(const Position& from, bool forwards, const Run::Progress& progress)
      : from_(from), forwards_(forwards), progress_(progress) {}

  /// `search(from, progress)` finds a moment that is `stop`.
  template <class Search>
  void add(Stop stop, Search search) {
    if (ended_) return;
    // Moments beyond the nearest so far do not matter.
    const auto in_reach = [&](std::uint32_t step) {
      if (nearest_ && (forwards_ ? step > nearest_->position.step : step < nearest_->position.step))
        return false;
      ended_ = progress_ && !progress_(step);
      return !ended_;
    };
    const std::optional<Position> found = search(from_, in_reach);
    if (!found || (nearest_ && (forwards_ ? *found >= nearest_->position : *found <= nearest_->position)))
      return;
    stop.position = *found;
    nearest_ = stop;
  }
  /// None if the search was ended.
  [[nodiscard]] std::optional<Stop> result() const { return ended_ ? std::nullopt : nearest_; }

 private:
  Position from_;
  bool forwards_;
  const Run::Progress& progress_;
  std::optional<Stop> nearest_;
  bool ended_ = false;
};

}  // namespace

std::optional<Stop> next_stop(Run& run, const std::vector<Breakpoint>& breakpoints,
                              const std::vector<WatchedValue>& watches, bool forwards,
                              const Run::Progress& progress) {
  NearestMoment nearest(run.position(), forwards, progress);
  for (std::size_t k = 0; k < breakpoints.size(); ++k) {
    if (!breakpoints[k].enabled) continue;
    nearest.add({{}, k, std::nullopt}, [&](const Position& from, const Run::Progress& in_reach) {
      return run.search(breakpoints[k].condition, from, forwards, in_reach);
    });
  }
  for (std::size_t k = 0; k < watches.size(); ++k) {
    if (!watches[k].stop) continue;
    nearest.add({{}, std::nullopt, k}, [&](const Position& from, const Run::Progress& in_reach) {
      return run.search_change(watches[k].expression, from, *watches[k].stop, forwards, in_reach);
    });
  }
  return nearest.result();
}

}  // namespace kerf
