#pragma once

#include <cstdint>
#include <string>

#include "frames/experiment/simulation.h"

namespace kerf {

/// The runs of an experiment: each simulation with each of some seeds, as often as it is repeated.
struct ExperimentPlan {
  ExperimentSize size;        ///< with the first seed
  std::uint32_t seeds = 3;    ///< consecutive ones
  std::uint32_t repeats = 1;  ///< each begins when all runs of the one before are done

  [[nodiscard]] std::uint32_t runs() const { return seeds * repeats; }
  /// The size of a run with the k-th seed.
  [[nodiscard]] ExperimentSize with_seed(std::uint32_t k) const {
    ExperimentSize result = size;
    result.seed += k;
    return result;
  }
  /// The command that makes these runs.
  [[nodiscard]] std::string command() const {
    return "kerf experiment --steps " + std::to_string(size.steps) + " --objects " +
           std::to_string(size.objects) + " --seed " + std::to_string(size.seed) + " --seeds " +
           std::to_string(seeds) + " --repeats " + std::to_string(repeats);
  }
};

}  // namespace kerf
