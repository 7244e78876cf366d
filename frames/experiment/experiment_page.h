#pragma once

#include <string>

#include "frames/experiment/experiment_plan.h"
#include "frames/experiment/simulation.h"

namespace kerf {

/// The text of experiment.md: the figures, a table of means for each simulation, and the verdict on each
/// statement of the paper's sections 6.2 and 7.
std::string experiment_text(const ExperimentPlan& plan, const ExperimentRuns& runs);

/// The page experiment.html: the same with curves that show their values, and a table of moments with the
/// commands that show them. It loads nothing. Throws std::runtime_error if gnuplot fails.
std::string experiment_page(const ExperimentPlan& plan, const ExperimentRuns& runs);

}  // namespace kerf
