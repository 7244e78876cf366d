#pragma once

#include <cstdint>
#include <string>

#include "frames/experiment/simulation.h"

namespace kerf {

/// Whose runs: of the paper's experiment, or of the related work on the same simulations.
enum class RunKind : std::uint8_t { paper, related };

/// The runs of an experiment: each simulation with each of some seeds, as often as it is repeated.
struct ExperimentPlan {
  RunKind kind = RunKind::paper;
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
    return std::string("kerf experiment ") + (kind == RunKind::related ? "--related " : "") + "--steps " +
           std::to_string(size.steps) + " --objects " + std::to_string(size.objects) + " --seed " +
           std::to_string(size.seed) + " --seeds " + std::to_string(seeds) + " --repeats " +
           std::to_string(repeats);
  }
};

}  // namespace kerf
