#include "frames/experiment/experiment_page.h"

#include <array>
#include <cstdio>
#include <sstream>
#include <string>

#include "frames/experiment/claims.h"
#include "frames/experiment/experiment_file.h"

namespace kerf {
namespace {

std::string number(double x, const char* format) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), format, x);
  return text.data();
}

constexpr const char* kMethod = R"(
Each simulation is run once on ODE, with all broad phases side by side: in each step all are given the same boxes, in
turns, and each is timed by itself. All have to deliver the same pairs, which is checked in each step; so what the paper
calls the number of pairs is here that of the *candidates* which a structure leaves to be tested (counted each fifth
step, for those that count them). *Overhead* is the taking over of boxes and all that brings a structure up to date,
*collision* the search for pairs; frames a second count narrow phase and dynamics, too, with one broad phase alone in
the loop. Times are of the processor.

`kerf-paper` is the paper's tree with the paper's parameters (BSP below), `kerf` the tuned one; `ode-quadtree` is QT,
`ode-hash` SH, `loose-octree` LO, `sweep-and-prune` SP. The number of objects grows in simulations 1 and 4.

![Figure 12](figure-12.svg)

![Figure 13](figure-13.svg)
)";

constexpr const char* kAfterVerdicts = R"(
"Similar" is within a factor of two. Where no other word is said, times are collision and overhead together. Reasons
are ours, from the code; the figures are this run's.

Not judged: how much QT and SH prune, as ODE reports only the pairs that remain; and what the paper calls reasonable or
substantial.
)";

void write_introduction(std::ostream& text, const ExperimentSize& size) {
  text << "# The paper's experiment, run again\n\n"
       << "Made by `kerf experiment --steps " << size.steps << " --objects " << size.objects << " --seed "
       << size.seed
       << "`: figures 12 and 13 of *Broad-Phase Collision Detection Using Semi-Adjusting BSP-trees*, "
       << "and what its section 6.2 says of them.\n"
       << kMethod;
}

/// The contestants that reported wrong pairs, and how often.
void write_wrong(std::ostream& text, const ExperimentRuns& runs) {
  text << "\n## Wrong answers\n\n";
  bool any = false;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    for (std::size_t k = 0; k < contestants().size(); ++k) {
      std::uint64_t pairs = 0;
      std::size_t steps = 0;
      for (const ExperimentStep& row : runs[run]) {
        pairs += row.contestants[k].wrong;
        steps += row.contestants[k].wrong > 0 ? 1U : 0U;
      }
      if (steps == 0) continue;
      any = true;
      text << "- " << contestants()[k] << " missed or invented " << pairs << " pairs in " << steps
           << " steps of simulation " << simulations()[run].number << ".\n";
    }
  }
  text << (any ? "\nBoxes and their order are the same for all: these are the libraries' own.\n"
               : "None: all delivered the same pairs in every step.\n");
}

void write_means(std::ostream& text, const Simulation& simulation, const ExperimentRun& run) {
  text << "\n## Simulation " << simulation.number << ": " << simulation.title << "\n\n"
       << "Scene `" << simulation.scene << "`, means of the medians of each twenty of " << run.size()
       << " steps, " << run.back().moving << " moving objects at the end; the steps are in ["
       << run_path("", simulation).string() << "](" << run_path("", simulation).string() << ").\n\n"
       << "| broad phase | frames/s | candidates | collision, ms | overhead, ms | together, ms |\n"
       << "|---|--:|--:|--:|--:|--:|\n";
  for (const std::string_view name : contestants()) {
    const Means means = means_of(run, name);
    text << "| " << name << " | " << number(means.fps, "%.1f") << " | "
         << (means.candidates < 0 ? "" : number(means.candidates, "%.0f")) << " | "
         << number(means.collision, "%.3f") << " | " << number(means.update, "%.3f") << " | "
         << number(means.total(), "%.3f") << " |\n";
  }
}

void write_verdicts(std::ostream& text, const ExperimentRuns& runs) {
  text << "\n## What the paper says (section 6.2), and what was found\n\n"
       << "| simulation | the paper | here | figures | if not, why |\n|--:|---|---|---|---|\n";
  for (const ClaimVerdict& verdict : judge_claims(runs))
    text << "| " << (verdict.simulation == 0 ? "all" : std::to_string(verdict.simulation)) << " | "
         << verdict.claim << " | " << (verdict.holds ? "holds" : "**does not hold**") << " | "
         << verdict.figures << " | " << verdict.reason << " |\n";
  text << kAfterVerdicts;
}

}  // namespace

std::string experiment_page(const ExperimentSize& size, const ExperimentRuns& runs) {
  std::ostringstream text;
  write_introduction(text, size);
  for (std::size_t k = 0; k < runs.size(); ++k) write_means(text, simulations()[k], runs[k]);
  write_wrong(text, runs);
  write_verdicts(text, runs);
  return text.str();
}

}  // namespace kerf
