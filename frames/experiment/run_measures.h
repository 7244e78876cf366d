#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "frames/experiment/measure.h"
#include "frames/experiment/simulation.h"

namespace kerf {

/// A figure of one step; negative: not counted in this step.
using StepValue = std::function<double(const ExperimentStep&)>;

/// The mean of the medians of stretches of twenty steps, so that a run that grows counts as a whole, and
/// short disturbances of the machine do not. NaN if there is no figure.
double mean_of_medians(std::span<const ExperimentStep> steps, const StepValue& value);

/// The figure of one run; NaN if it has none.
double measure(const ExperimentRun& run, std::string_view contestant, Measure measure);

/// The samples of a quantity: one a run for times; one a seed for counts, which no repeat changes.
std::vector<double> samples_of(const std::vector<TimedRun>& runs, std::string_view contestant,
                               Measure measure);

/// Of all quantities of which the claims speak, with that reading of the paper's tree for BSP.
ClaimFigures claim_figures(const ExperimentRuns& runs, std::string_view tree);

}  // namespace kerf
