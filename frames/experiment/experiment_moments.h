#pragma once

#include <string>
#include <vector>

#include "frames/experiment/experiment_plan.h"
#include "frames/experiment/simulation.h"
#include "frames/page/page.h"

namespace kerf {

/// The address of a moment on the page, without "#".
std::string moment_address(const Simulation& simulation, const std::string& step);

/// Adds a table of the moments at which the curves have their points, in the first run: its figures, and the
/// command that shows each in a recording of the same run, with the command that makes the recording.
void write_moments(Page& page, const ExperimentPlan& plan, const Simulation& simulation,
                   const std::vector<TimedRun>& runs);

}  // namespace kerf
