#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "frames/experiment/simulation.h"

namespace kerf {

/// The file of a run in the folder of an experiment: CSV, a line for each step and broad phase.
std::filesystem::path run_path(const std::filesystem::path& folder, const Simulation& simulation,
                               const ExperimentSize& size, std::uint32_t repeat);

/// Writes it such that it appears only when it is complete.
void save_run(const std::filesystem::path& folder, const Simulation& simulation, const ExperimentSize& size,
              std::uint32_t repeat, const ExperimentRun& run);

/// The saved run; none if there is no file. Throws UsageError for one of another size or of an earlier kerf,
/// unless `forget` says that it counts as none, and std::runtime_error for one that cannot be read: all say
/// what to do.
std::optional<ExperimentRun> load_run(const std::filesystem::path& folder, const Simulation& simulation,
                                      const ExperimentSize& size, std::uint32_t repeat, bool forget);

/// Throws UsageError if the folder has the file of a simulation as kerf wrote it when it ran each once: the
/// times in it are measured otherwise and have no spread.
void refuse_earlier_files(const std::filesystem::path& folder);

}  // namespace kerf
