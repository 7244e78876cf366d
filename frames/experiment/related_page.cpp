#include <algorithm>

#include "core/base/counted.h"
#include "frames/catalog/algorithm.h"
#include "frames/experiment/related.h"
#include "frames/page/page.h"
#include "frames/page/plot.h"
#include "viz/draw/palette.h"

namespace kerf {
namespace {

/// The mean of the runs.
double mean_of(const std::vector<RelatedRun>& runs, std::size_t contestant, std::size_t part,
               double RelatedFigures::*figure) {
  double sum = 0;
  for (const RelatedRun& run : runs) sum += run.parts[contestant][part].*figure;
  return runs.empty() ? 0 : sum / static_cast<double>(runs.size());
}

double mean_of_run(const std::vector<RelatedRun>& runs, std::size_t contestant,
                   double RelatedFigures::*figure) {
  double sum = 0;
  for (std::size_t part = 0; part < kRelatedParts; ++part) sum += mean_of(runs, contestant, part, figure);
  return sum / static_cast<double>(kRelatedParts);
}

Plot plot_over_time(const std::string& title, const std::vector<RelatedRun>& runs,
                    const ExperimentSize& size) {
  Plot plot{title, "step", "pairs of boxes compared", false, true, {}};
  const auto names = related_contestants();
  for (std::size_t k = 0; k < names.size(); ++k) {
    // There are more of them than colours.
    PlotSeries series{
        std::string(names[k]), {}, k < palette::kSeries.size() ? PlotStyle::line : PlotStyle::dashed};
    for (std::size_t part = 0; part < kRelatedParts; ++part) {
      const double step = (static_cast<double>(part) + 0.5) * size.steps / static_cast<double>(kRelatedParts);
      series.points.push_back({step, mean_of(runs, k, part, &RelatedFigures::candidates)});
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

void write_verdicts(Page& page, const RelatedRuns& runs) {
  Json rows = Json::array();
  for (const RelatedClaim& claim : related_claims()) {
    const RelatedVerdict verdict = judge(claim, runs);
    rows.push_back(
        {{"words", std::string(claim.words)},
         {"outcome", std::string(name_of(verdict.outcome))},
         {"figures", verdict.figures},
         {"of",
          claim.subject.empty() ? "" : std::string(claim.subject) + " over " + std::string(claim.rival)},
         {"note", std::string(claim.note)}});
  }
  page.table("what section 2 says, and what is so here (simulations 1 to 4)",
             {{.title = "section 2", .key = "words", .wraps = true},
              {"verdict", "outcome"},
              {.title = "figures", .key = "figures", .wraps = true},
              {.title = "of", .key = "of", .wraps = true},
              {.title = "read as", .key = "note", .wraps = true}},
             rows, {}, true);
}

void write_simulation(Page& page, const Simulation& simulation, const std::vector<RelatedRun>& runs,
                      const ExperimentSize& size) {
  const std::string title =
      "Simulation " + std::to_string(simulation.number) + ": " + std::string(simulation.title);
  page.figure(draw(plot_over_time(title, runs, size), "related" + std::to_string(simulation.number)),
              "Means of tenths of a run, over all runs.");
  Json rows = Json::array();
  const auto names = related_contestants();
  for (std::size_t k = 0; k < names.size(); ++k) {
    std::uint64_t wrong = 0;
    for (const RelatedRun& run : runs) wrong += run.wrong[k];
    rows.push_back({{"name", std::string(names[k])},
                    {"what", find_algorithm<3>(names[k])->what},
                    {"candidates", mean_of_run(runs, k, &RelatedFigures::candidates)},
                    {"update", mean_of_run(runs, k, &RelatedFigures::update)},
                    {"collision", mean_of_run(runs, k, &RelatedFigures::collision)},
                    {"wrong", wrong}});
  }
  page.table("its figures",
             {{"broad phase", "name"},
              {.title = "what it is", .key = "what", .wraps = true},
              {"pairs compared", "candidates"},
              {.title = "update, ms", .key = "update", .digits = 3},
              {.title = "collision, ms", .key = "collision", .digits = 3},
              {"wrong pairs", "wrong"}},
             rows, {}, true);
}

}  // namespace

std::string related_page(const ExperimentPlan& plan, const RelatedRuns& runs) {
  Page page("The related work of the paper",
            std::to_string(plan.size.objects) + " objects, " + std::to_string(plan.size.steps) + " steps, " +
                counted(plan.repeats, "repeat") + " of " + counted(plan.seeds, "seed"));
  page.section("verdicts", "What the paper says of them");
  page.paragraph(
      "Each is built as its source says, on boxes; where the source leaves things open, the comment of its "
      "header says how it was read. A sentence holds if it does in every run. All get the same boxes in each "
      "step, in turns, and all have to report the same pairs. Times are of the processor; a run has a "
      "process of its own.");
  write_verdicts(page, runs);
  page.section("figures", "Figures over time");
  for (std::size_t k = 0; k < runs.size(); ++k) write_simulation(page, simulations()[k], runs[k], plan.size);
  page.command(plan.command());
  return page.html();
}

}  // namespace kerf
