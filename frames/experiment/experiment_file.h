#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "frames/experiment/experiment_plan.h"

namespace kerf {

/// One of the runs of an experiment.
struct RunId {
  RunKind kind = RunKind::paper;
  std::size_t simulation = 0;  ///< place in `simulations()`
  ExperimentSize size;         ///< with the run's seed
  std::uint32_t repeat = 1;    ///< from 1
};

/// "simulation 2 (attractors), seed 1, repeat 3".
std::string name_of(const RunId& run);
/// Other readings of the paper's tree run in the first repeat only, and candidates of the paper's broad
/// phases are counted in it, since later ones have the same.
Lineup lineup_of(const RunId& run);

/// The file of a run in the folder of an experiment: CSV, a line for each step and broad phase.
std::filesystem::path run_path(const std::filesystem::path& folder, const RunId& run);

/// Writes it such that it appears only when it is complete.
void save_run(const std::filesystem::path& folder, const RunId& run, const ExperimentRun& steps);

/// The saved run; none if there is no file. Throws UsageError for one of another size or of another build of
/// kerf, unless `forget` says that it counts as none, and std::runtime_error for one that cannot be read: all
/// say what to do.
std::optional<ExperimentRun> load_run(const std::filesystem::path& folder, const RunId& id, bool forget);

/// Throws UsageError if the folder has the file of a simulation as kerf wrote it when it ran each once: the
/// times in it are measured otherwise and have no spread.
void refuse_earlier_files(const std::filesystem::path& folder);

}  // namespace kerf
