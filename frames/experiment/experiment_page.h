#pragma once

#include <filesystem>

#include "frames/experiment/experiment_plots.h"

namespace kerf {

/// Writes experiment.md: the figures, a table of means for each simulation, and the verdict on each claim of
/// the paper's section 6.2.
void write_experiment_page(const std::filesystem::path& folder, const ExperimentSize& size,
                           const ExperimentRuns& runs);

}  // namespace kerf
