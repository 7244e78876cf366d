#pragma once

#include <array>
#include <filesystem>

#include "frames/experiment/simulation.h"

namespace kerf {

/// By simulation number - 1.
using ExperimentRuns = std::array<ExperimentRun, 4>;

/// Draws the paper's figures 12 (simulations 1 and 2, a column each) and 13 (3 and 4) by gnuplot, each as
/// figure-12.svg and .png and so on. Throws std::runtime_error, saying what to do, if gnuplot fails.
void plot_experiment(const std::filesystem::path& folder, const ExperimentRuns& runs);

}  // namespace kerf
