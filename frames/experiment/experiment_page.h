#pragma once

#include <string>

#include "frames/experiment/experiment_plots.h"

namespace kerf {

/// The text of experiment.md: the figures, a table of means for each simulation, and the verdict on each
/// claim of the paper's section 6.2.
std::string experiment_page(const ExperimentSize& size, const ExperimentRuns& runs);

}  // namespace kerf
