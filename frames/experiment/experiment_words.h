#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "frames/experiment/experiment_plan.h"
#include "frames/experiment/simulation.h"
#include "frames/experiment/verdict.h"

namespace kerf {

/// What both pages of an experiment, text and HTML, say in the same words.

inline constexpr std::string_view kExperimentTitle = "The paper's experiment, run again";

/// How it is measured, a paragraph each.
std::vector<std::string> method_words(const ExperimentPlan& plan);

/// How verdicts come about.
std::string verdict_words();

/// A line for each contestant and simulation with wrong pairs; empty if there are none.
std::vector<std::string> wrong_words(const ExperimentRuns& runs);

/// "12 hold, 5 partly, 8 the opposite, 9 cannot be judged".
std::string count_words(const std::vector<ClaimVerdict>& verdicts);

/// The paper's words, and how they are read.
std::string statement_words(const Claim& claim);

/// "1", or "all" for a claim on several.
std::string simulation_words(const Claim& claim);

/// Of all claims, in their order.
std::vector<ClaimVerdict> judge_all(const ExperimentRuns& runs);

}  // namespace kerf
