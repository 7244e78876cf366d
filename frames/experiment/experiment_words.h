#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "frames/experiment/experiment_plan.h"
#include "frames/experiment/reading.h"
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

/// How many verdicts have each outcome, in the order of the enumeration.
std::array<std::size_t, 4> count_outcomes(const std::vector<ClaimVerdict>& verdicts);

/// "12 hold, 5 partly, 8 the opposite, 9 cannot be judged".
std::string count_words(const std::vector<ClaimVerdict>& verdicts);

/// What the readings of the paper's tree are about.
std::vector<std::string> reading_words();

/// The figures of one reading in one simulation, as text.
struct ReadingCells {
  std::string leaves;  ///< "10 to 59", after the first third of the first run; the next likewise
  std::string depth;
  std::string depth_change;
  std::string leaves_swing;
  std::string pairs;
  std::string collision;
  std::string overhead;
};
ReadingCells reading_cells(const Reading& reading, const std::vector<TimedRun>& runs);

/// The paper's words, and how they are read.
std::string statement_words(const Claim& claim);

/// "1", or "all" for a claim on several.
std::string simulation_words(const Claim& claim);

/// Of all claims, in their order, with that reading of the paper's tree for BSP.
std::vector<ClaimVerdict> judge_all(const ExperimentRuns& runs, std::string_view tree);

}  // namespace kerf
