#pragma once

#include <filesystem>
#include <optional>

#include "frames/experiment/simulation.h"

namespace kerf {

/// The file of a simulation in the folder of an experiment: CSV, a line for each step and broad phase.
std::filesystem::path run_path(const std::filesystem::path& folder, const Simulation& simulation);

/// Writes it such that it appears only when it is complete.
void save_run(const std::filesystem::path& folder, const Simulation& simulation, const ExperimentSize& size,
              const ExperimentRun& run);

/// The saved run; none if there is no file. Throws UsageError for one of another size, unless `forget` says
/// that it counts as none, and std::runtime_error for one that cannot be read: both say what to do.
std::optional<ExperimentRun> load_run(const std::filesystem::path& folder, const Simulation& simulation,
                                      const ExperimentSize& size, bool forget);

}  // namespace kerf
