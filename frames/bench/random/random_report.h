#pragma once

#include <string>
#include <vector>

#include "frames/bench/bench_cell.h"
#include "frames/bench/bench_request.h"
#include "frames/bench/random/random_scene.h"

namespace kerf {

/// What was measured of a random scene.
struct RandomOutcome {
  RandomScene scene;
  CellResult cell;
};

/// The tuned tree beside the fastest other algorithm that came to the end with the right pairs.
struct RandomDuel {
  const BenchRow* tree = nullptr;   ///< null: the tree did not
  const BenchRow* other = nullptr;  ///< null: none of the others did
  RoundRatio ratio;                 ///< time of the other over that of the tree, if both did
};
RandomDuel duel_of(const RandomOutcome& outcome);

/// The command that measures this scene alone.
std::string repeat_command(const BenchRequest& request, const RandomScene& scene);

/// The line above those of the scenes.
std::string random_heading();
std::string as_text(const RandomOutcome& outcome);

/// The geometric mean, a histogram, and the worst scenes with the commands that repeat them.
std::string random_summary(const BenchRequest& request, const std::vector<RandomOutcome>& all);

/// {"machine", "settings", "scenes": [{"drawn": {...}, "measured": properties, "command", "ratio", "least",
/// "most", "other", "results": [rows], "gaps"}], "complete"}
std::string as_json(const BenchRequest& request, const std::vector<RandomOutcome>& all, bool complete);

}  // namespace kerf
