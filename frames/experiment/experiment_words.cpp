#include "frames/experiment/experiment_words.h"

#include "core/base/counted.h"
#include "frames/experiment/run_measures.h"
#include "frames/experiment/spread.h"
#include "frames/page/short_number.h"

namespace kerf {
namespace {

constexpr std::uint32_t kEnoughSeeds = 3;
constexpr std::uint32_t kEnoughRepeats = 5;

std::string run_words(const ExperimentPlan& plan) {
  std::string text = "Each simulation was run " + counted(plan.runs(), "time") + ": " +
                     counted(plan.repeats, "repeat") + " of " + counted(plan.seeds, "seed") +
                     "; repeats follow one another.";
  if (plan.seeds < kEnoughSeeds || plan.repeats < kEnoughRepeats)
    text +=
        " These are fewer than the three seeds and five repeats of kerf experiment --full: the spreads are "
        "likely too narrow.";
  return text;
}

}  // namespace

std::vector<std::string> method_words(const ExperimentPlan& plan) {
  return {
      run_words(plan),
      "Each run is on ODE in a process of its own, with all broad phases side by side: in each step all are "
      "given the same boxes, in turns, and each is timed by itself. All have to report the same pairs, which "
      "is checked in each step. So what the paper calls the number of pairs is here the number of pairs "
      "whose boxes a structure leaves to be compared, counted in each fifth step of the first repeat. Pairs "
      "of two fixed objects are among them where a structure compares their boxes (BSP, LO) and not where it "
      "excludes them before (QT, SH, SP).",
      "Overhead is the taking over of boxes and all that brings a structure up to date; collision time is "
      "the search for pairs. SP finds its overlaps while it orders its lists, which is overhead here. Frames "
      "a second count the narrow phase and the dynamics, too, with one broad phase alone in the loop; they "
      "are one over the mean time of a frame. Times are of the processor. A figure is the mean of the "
      "medians of each twenty steps of a run; behind it stands its spread over the runs, without the tenth "
      "of them at either end. Counts do not change from repeat to repeat, so they have a sample for each "
      "seed only.",
      "BSP is the paper's tree with the paper's parameters (kerf-paper), tuned BSP is kerf as it is. QT and "
      "SH are ODE's quadtree and hash space: the quadtree divides the XZ plane as in the paper (ODE 0.16 "
      "divides X and Y, so that it is given boxes with Y and Z exchanged). LO is our loose octree, SP our "
      "sweep-and-prune, ODE SAP is ODE's later space. The number of objects grows in simulations 1 and 4."};
}

std::string verdict_words() {
  return "Each statement is judged in the measure that the paper means; where SP's collision time or "
         "overhead is one of the figures, the verdict depends on where its search is counted. Figures are "
         "compared run by run. Similar and small mean up to a factor of " +
         short_number(kTolerance) +
         ", much, big and substantial mean more; figures within 2 % are alike. Partly: half of its "
         "comparisons or more are as the paper says, or it is true in kind and not in degree. Opposite: most "
         "are the other way round. What the spread leaves open cannot be judged, nor can what names no "
         "figure. Better and worse say how ours (BSP, or else LO or SP) stand beside the paper's words.";
}

std::vector<std::string> wrong_words(const ExperimentRuns& runs) {
  std::vector<std::string> lines;
  for (std::size_t simulation = 0; simulation < runs.size(); ++simulation)
    for (std::size_t k = 0; k < contestants().size(); ++k) {
      std::uint64_t pairs = 0;
      std::size_t steps = 0;
      for (const TimedRun& run : runs[simulation])
        for (const ExperimentStep& row : run.steps) {
          if (k >= row.contestants.size()) continue;
          pairs += row.contestants[k].wrong;
          steps += row.contestants[k].wrong > 0 ? 1U : 0U;
        }
      if (steps > 0)
        lines.push_back(std::string(contestants()[k]) + " missed or invented " + std::to_string(pairs) +
                        " pairs in " + std::to_string(steps) + " steps of simulation " +
                        std::to_string(simulations()[simulation].number) + ".");
    }
  return lines;
}

std::array<std::size_t, 4> count_outcomes(const std::vector<ClaimVerdict>& verdicts) {
  std::array<std::size_t, 4> counts{};
  for (const ClaimVerdict& verdict : verdicts) ++counts[static_cast<std::size_t>(verdict.outcome)];
  return counts;
}

std::string count_words(const std::vector<ClaimVerdict>& verdicts) {
  const auto [holds, partly, opposite, not_judged] = count_outcomes(verdicts);
  return "Of " + std::to_string(verdicts.size()) + " statements " + std::to_string(holds) + " hold, " +
         std::to_string(partly) + " hold partly, of " + std::to_string(opposite) +
         " the opposite is found, and " + std::to_string(not_judged) + " cannot be judged.";
}

std::vector<std::string> reading_words() {
  return {
      "The paper leaves some questions open. Each answer that its words allow ran beside the others, on the "
      "same boxes, in the first repeat of each seed; the first is what BSP is above, and docs/DESIGN.md says "
      "why. Statements are counted over these runs alone, so that all readings have the same."};
}

ReadingCells reading_cells(const Reading& reading, const std::vector<TimedRun>& runs) {
  const ReadingShape shape = shape_of(runs.front().steps, reading.contestant);
  const auto range = [](double least, double most) {
    return short_number(least) + " to " + short_number(most);
  };
  const auto text = [&](Measure measure) {
    const auto spread = spread_of(samples_of(runs, reading.contestant, measure));
    return spread ? text_of(*spread) : "";
  };
  return {range(shape.least_leaves, shape.most_leaves),
          range(shape.least_depth, shape.most_depth),
          text(Measure::depth_change),
          text(Measure::leaves_swing),
          text(Measure::pairs),
          text(Measure::collision),
          text(Measure::overhead)};
}

std::string statement_words(const Claim& claim) {
  const bool has_reading = !claim.comparisons.empty() && !claim.note.empty();
  return std::string(claim.words) + (has_reading ? " (" + std::string(claim.note) + ")" : "");
}

std::string simulation_words(const Claim& claim) {
  return claim.simulation == 0 ? "all" : std::to_string(claim.simulation);
}

std::vector<ClaimVerdict> judge_all(const ExperimentRuns& runs, std::string_view tree) {
  const ClaimFigures figures = claim_figures(runs, tree);
  std::vector<ClaimVerdict> verdicts;
  for (const Claim& claim : claims()) verdicts.push_back(judge(claim, figures));
  return verdicts;
}

}  // namespace kerf
