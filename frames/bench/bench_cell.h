#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "frames/bench/bench_row.h"
#include "frames/bench/bench_scene.h"
#include "frames/bench/scene_properties.h"

namespace kerf {

/// The measurement of one cell.
struct CellPlan {
  std::string scene;  ///< of `bench_scenes()`, or any name of a motion that the caller makes
  std::uint32_t objects = 1000;
  unsigned threads = 1;
  std::vector<std::string> algorithms;
  std::uint32_t rounds = 3;
  std::uint32_t warm_up = 32;  ///< steps before those that count
  std::uint32_t steps = 100;
  std::uint64_t seed = 1;
  double patience = 30;  ///< seconds of measuring in a round after which an algorithm is left out
  bool trace = false;    ///< keep the time of each step
  bool tests = false;    ///< count tests per pair
};

/// Callbacks of a running cell.
struct CellWatch {
  std::function<void(const std::string&)> progress;
  std::function<bool()> stop;
};

struct CellResult {
  std::vector<BenchRow> rows;  ///< the floor first
  std::vector<BenchGap> gaps;
  SceneProperties properties;  ///< of the measured steps
};

/// Makes a motion from its beginning, the same each time.
template <int D>
using MotionSource = std::function<std::unique_ptr<Motion<D>>()>;

/// Measures all algorithms of the plan that exist for D dimensions and that many threads.
///
/// Each algorithm lives in a process of its own. The motion is computed a block of steps at a time; then each
/// algorithm in turn does these steps, and the next block begins with another of them. Whole blocks and not
/// single steps, because a step right after another algorithm's measures the caches that it left behind;
/// blocks and not whole runs, because the machine changes from minute to minute. After an interrupt the rows
/// so far are returned.
template <int D>
CellResult measure_cell(const CellPlan& plan, const MotionSource<D>& make, const CellWatch& watch);
/// The same of the scene that has the plan's name.
template <int D>
CellResult measure_cell(const CellPlan& plan, const CellWatch& watch);

}  // namespace kerf
