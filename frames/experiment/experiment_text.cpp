#include <sstream>
#include <string>

#include "frames/catalog/algorithm.h"
#include "frames/experiment/experiment_file.h"
#include "frames/experiment/experiment_page.h"
#include "frames/experiment/experiment_words.h"
#include "frames/experiment/run_measures.h"
#include "frames/experiment/spread.h"

namespace kerf {
namespace {

void write_introduction(std::ostream& text, const ExperimentPlan& plan) {
  text << "# " << kExperimentTitle << "\n\nMade by `" << plan.command()
       << "`: figures 12 and 13 of *Broad-Phase Collision Detection Using Semi-Adjusting BSP-trees*, and "
          "what its sections 6.2 and 7 say of them. [experiment.html](experiment.html) has curves that show "
          "their values.\n\n";
  for (const std::string& paragraph : method_words(plan)) text << paragraph << "\n\n";
  text << "![Figure 12](figure-12.svg)\n\n![Figure 13](figure-13.svg)\n";
}

std::string cell(const std::vector<TimedRun>& runs, std::string_view contestant, Measure measure) {
  const auto spread = spread_of(samples_of(runs, contestant, measure));
  return spread ? text_of(*spread) : "";
}

void write_means(std::ostream& text, const ExperimentPlan& plan, const Simulation& simulation,
                 const std::vector<TimedRun>& runs) {
  const std::string file =
      run_path("", {.simulation = static_cast<std::size_t>(simulation.number - 1), .size = plan.size})
          .string();
  text << "\n## Simulation " << simulation.number << ": " << simulation.title << "\n\nScene `"
       << simulation.scene << "`, " << plan.size.steps << " steps, " << runs.front().steps.back().moving
       << " moving objects at the end; the steps of the first run are in [" << file << "](" << file
       << ").\n\n| | broad phase | frames/s | pairs to test | collision, ms | overhead, ms |\n"
       << "|---|---|--:|--:|--:|--:|\n";
  for (const std::string_view name : contestants_in_figures()) {
    text << "| " << paper_name(name) << " | " << name;
    for (const Measure measure : {Measure::frames, Measure::pairs, Measure::collision, Measure::overhead})
      text << " | " << cell(runs, name, measure);
    text << " |\n";
  }
}

void write_wrong(std::ostream& text, const ExperimentRuns& runs) {
  text << "\n## Wrong answers\n\n";
  const std::vector<std::string> lines = wrong_words(runs);
  for (const std::string& line : lines) text << "- " << line << "\n";
  text << (lines.empty()
               ? "None: all reported the same pairs in every step.\n"
               : "\nBoxes and their order are the same for all; the pairs of BSP are held to be true.\n");
}

void write_verdicts(std::ostream& text, const ExperimentRuns& runs) {
  const std::vector<ClaimVerdict> verdicts = judge_all(runs, kPaperTree);
  text << "\n## What the paper says, and what was found\n\n"
       << count_words(verdicts) << " " << verdict_words()
       << "\n\n| simulation | section | the paper | verdict | ours | figures | why |\n"
       << "|--:|--:|---|---|---|---|---|\n";
  for (std::size_t k = 0; k < verdicts.size(); ++k) {
    const Claim& claim = claims()[k];
    text << "| " << simulation_words(claim) << " | " << claim.section << " | " << statement_words(claim)
         << " | **" << name_of(verdicts[k].outcome) << "** | " << text_of_standing(verdicts[k]) << " | "
         << verdicts[k].figures << " | " << verdicts[k].reason << " |\n";
  }
}

void write_readings(std::ostream& text, const ExperimentRuns& runs) {
  text << "\n## The paper's tree in other readings\n\n";
  for (const std::string& paragraph : reading_words()) text << paragraph << "\n\n";
  text << "| reading | broad phase | the paper's words, and how they are read | hold | partly | opposite | "
          "cannot be judged |\n|---|---|---|--:|--:|--:|--:|\n";
  for (const Reading& reading : readings()) {
    text << "| " << reading.label << " | " << reading.contestant << " | " << reading.words;
    for (const std::size_t count : count_outcomes(judge_all(runs, reading.contestant)))
      text << " | " << count;
    text << " |\n";
  }
  text << "\n| simulation | reading | leaves | depth | greatest change of depth in ten steps | leaves, "
          "greatest over least fifth | pairs to test | collision, ms | overhead, ms |\n"
       << "|--:|---|--:|--:|--:|--:|--:|--:|--:|\n";
  for (std::size_t k = 0; k < runs.size(); ++k)
    for (const Reading& reading : readings()) {
      const ReadingCells cells = reading_cells(reading, runs[k]);
      text << "| " << k + 1 << " | " << reading.label;
      for (const std::string& one : {cells.leaves, cells.depth, cells.depth_change, cells.leaves_swing,
                                     cells.pairs, cells.collision, cells.overhead})
        text << " | " << one;
      text << " |\n";
    }
}

}  // namespace

std::string experiment_text(const ExperimentPlan& plan, const ExperimentRuns& runs) {
  std::ostringstream text;
  write_introduction(text, plan);
  for (std::size_t k = 0; k < runs.size(); ++k) write_means(text, plan, simulations()[k], runs[k]);
  write_wrong(text, runs);
  write_readings(text, first_repeats(runs));
  write_verdicts(text, runs);
  return text.str();
}

}  // namespace kerf
