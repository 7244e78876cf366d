#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "frames/bench/bench_cell.h"
#include "frames/catalog/scene_catalog.h"

namespace kerf {

/// What is measured of the broad phases in a simulation.
struct LoopPlan {
  CatalogScene scene;
  SceneOptions options;
  std::vector<std::string> broad_phases;  ///< names that `kerf render --broad-phase` takes
  std::vector<std::string> variants;  ///< "kerf:K=V...": given the boxes of each loop in turn with its own
  std::uint32_t rounds = 3;
  std::uint32_t warm_up = 0;  ///< steps before those that count; the scene grows meanwhile
  std::uint32_t steps = 100;
};

/// A broad phase in a simulation and, given the same boxes, alone. Times are nanoseconds an object and step:
/// the median over the steps, of each of which the least of the rounds counts.
struct LoopRow {
  std::string scene;
  std::string broad_phase;
  int dimension = 3;
  std::uint32_t objects = 0;  ///< in the last step, fixed ones included
  double loop_ns = 0;         ///< requests and step within the simulation
  double alone_ns = 0;        ///< the same requests and step, many steps in a row, as `kerf bench` does them
  double ratio = 0;           ///< the median over the steps of loop over alone
  double share = 0;           ///< of the simulation's step that the broad phase takes
  std::uint32_t steps = 0;    ///< measured
  std::vector<BenchRow> alone;  ///< the broad phase alone, and each variant, with the times of each round
};

/// Runs the scene with each broad phase in its loop, as `kerf render` does; our trees are recorded beside, as
/// `kerf record` does, and what the recorder takes is not counted. Broad phases alone take turns: each is
/// given a block of steps, and the next block begins with another of them. Throws std::logic_error if one
/// reports other pairs than the broad phase in the loop.
std::vector<LoopRow> measure_loops(const LoopPlan& plan, const CellWatch& watch);

}  // namespace kerf
