#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace kerf {

/// One of the paper's four simulations (section 6.2).
struct Simulation {
  int number = 1;
  std::string_view scene;  ///< the corresponding 3D scene
  std::string_view title;
};
std::span<const Simulation> simulations();

/// The broad phases of the experiment: the tree with the paper's parameters and the paper's four rivals, then
/// the tuned tree and ODE's later space; behind these the paper's tree in its other readings.
std::span<const std::string_view> contestants();
/// Those before the other readings.
std::span<const std::string_view> contestants_in_figures();
/// Those of a repeat: the other readings run in the first one only, since it is their counts that are asked.
std::span<const std::string_view> contestants_in(std::uint32_t repeat);
/// The broad phases of a run.
struct Lineup {
  std::span<const std::string_view> names;  ///< the world follows the first, whose pairs are held to be true
  bool counts = true;                       ///< the pairs that they leave to be compared, too
};
/// The paper's name of a contestant in figures: "BSP", "QT", "SH", "LO" or "SP"; a like one for those that it
/// has not.
std::string_view paper_name(std::string_view contestant);

/// The size of a simulation.
struct ExperimentSize {
  std::uint32_t steps = 1200;
  std::uint32_t objects = 2000;  ///< moving ones at the end
  std::uint64_t seed = 1;
};

/// What one broad phase did in one step. Times are milliseconds of processor.
struct ContestantStep {
  double update = 0;         ///< overhead: taking over the boxes and bringing the structure up to date
  double collision = 0;      ///< finding the pairs
  std::uint64_t wrong = 0;   ///< pairs that it missed, invented or reported twice
  double candidates = -1;    ///< pairs whose boxes its structure left to be compared; negative: not counted
  std::uint32_t height = 0;  ///< of a tree, and so are the next two
  std::uint32_t leaves = 0;
  std::uint64_t operators = 0;  ///< so far
};

/// The results of all of them in one step.
struct ExperimentStep {
  std::uint32_t step = 0;
  std::uint32_t moving = 0;
  std::uint64_t pairs = 0;  ///< the true pairs
  std::uint64_t contacts = 0;
  double rest = 0;                          ///< milliseconds of narrow phase and dynamics
  std::vector<ContestantStep> contestants;  ///< in the order of `contestants()`, those of the repeat

  /// Frames a second with only that broad phase in the loop.
  [[nodiscard]] double fps(std::size_t contestant) const {
    return 1000 / (rest + contestants[contestant].update + contestants[contestant].collision);
  }
};

using ExperimentRun = std::vector<ExperimentStep>;

/// One of the runs of a simulation.
struct TimedRun {
  std::uint64_t seed = 1;
  std::uint32_t repeat = 1;  ///< from 1
  ExperimentRun steps;
};

/// By simulation number - 1; each simulation has the same runs, all seeds of the first repeat first.
using ExperimentRuns = std::array<std::vector<TimedRun>, 4>;

/// Those that all readings have.
ExperimentRuns first_repeats(const ExperimentRuns& runs);

/// Runs a simulation once with all broad phases side by side: each gets the same boxes in each step, in
/// turns, and is timed by itself. The world follows the first of them; differences of the others' pairs from
/// its pairs are counted. `watch(step)` is called before each step and ends the run by returning false.
ExperimentRun run_simulation(const Simulation& simulation, const ExperimentSize& size, const Lineup& lineup,
                             const std::function<bool(std::uint32_t step)>& watch);

}  // namespace kerf
