#pragma once

#include <string>
#include <vector>

#include "frames/experiment/experiment_plots.h"

namespace kerf {

/// A statement of the paper's section 6.2 and the verdict on it here.
struct ClaimVerdict {
  int simulation = 0;  ///< 0: of all
  std::string claim;   ///< in the paper's words, shortened
  bool holds = false;
  std::string figures;  ///< the basis of the verdict
  std::string reason;   ///< why it does not hold; empty if it does
};

/// All statements that figures can decide, in the paper's order. "BSP" is the tree with the paper's
/// parameters.
std::vector<ClaimVerdict> judge_claims(const ExperimentRuns& runs);

/// The cost of a run in milliseconds a step and in pairs: the mean of the medians of stretches of twenty
/// steps. So a run that grows counts as a whole, and short disturbances of the machine do not.
struct Means {
  double fps = 0;
  double collision = 0;
  double update = 0;
  double candidates = -1;  ///< negative: unknown
  [[nodiscard]] double total() const { return collision + update; }
};

/// Of the steps from `begin` to `end`, parts of the whole.
Means means_of(const ExperimentRun& run, std::string_view contestant, double begin = 0, double end = 1);

}  // namespace kerf
