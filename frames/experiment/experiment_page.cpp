#include "frames/experiment/experiment_page.h"

#include <array>
#include <string>
#include <vector>

#include "frames/catalog/algorithm.h"
#include "frames/catalog/scene_catalog.h"
#include "frames/experiment/experiment_file.h"
#include "frames/experiment/experiment_panels.h"
#include "frames/experiment/experiment_plan.h"
#include "frames/experiment/experiment_words.h"
#include "frames/experiment/reading.h"
#include "frames/experiment/run_measures.h"
#include "frames/experiment/simulation.h"
#include "frames/experiment/spread.h"
#include "frames/page/page.h"
#include "frames/page/short_number.h"

namespace kerf {
namespace {

constexpr std::size_t kPaperContestants = 5;

std::string recording_name(const Simulation& simulation) {
  return "simulation-" + std::to_string(simulation.number) + "-" + std::string(simulation.scene) + ".kerf";
}

/// The same run, since every exact broad phase leads to the same; the tree has the paper's parameters.
std::string record_command(const ExperimentPlan& plan, const Simulation& simulation) {
  const CatalogScene found = find_scene(simulation.scene);
  const bool grows = std::get<const SceneEntry<3>*>(found.entry)->grows;
  const std::string steps = std::to_string(plan.size.steps);
  return "kerf record " + std::string(simulation.scene) + " -o " + recording_name(simulation) +
         " --objects " + std::to_string(plan.size.objects) + " --steps " + steps +
         (grows ? " --grow " + steps : "") + " --seed " + std::to_string(plan.size.seed);
}

/// The address of a moment on the page, without "#".
std::string moment_address(const Simulation& simulation, const std::string& step) {
  return "moment-" + std::to_string(simulation.number) + "-" + step;
}

Json moment_row(const Simulation& simulation, const ExperimentStep& row) {
  const std::string step = std::to_string(row.step);
  Json json{{kRowId, moment_address(simulation, step)},
            {"step", step},
            {"moving", row.moving},
            {"pairs", row.pairs},
            {"contacts", row.contacts},
            {"depth", row.contestants[0].height},
            {"leaves", row.contestants[0].leaves}};
  for (std::size_t k = 0; k < kPaperContestants; ++k)
    json[std::string(contestants()[k])] =
        short_number(row.contestants[k].collision + row.contestants[k].update);
  json["command"] =
      "kerf step " + recording_name(simulation) + " --to step==" + step + " --picture step-" + step + ".png";
  return json;
}

/// Adds a table of the moments at which the curves have their points, in the first run: its figures, and the
/// command that shows each in a recording of the same run, with the command that makes the recording.
void write_moments(Page& page, const ExperimentPlan& plan, const Simulation& simulation,
                   const std::vector<TimedRun>& runs) {
  const ExperimentRun& first = runs.front().steps;
  Json rows = Json::array();
  for (const std::uint32_t step : curve_steps(first)) rows.push_back(moment_row(simulation, first[step - 1]));
  std::vector<TableColumn> columns{{"step", "step"},         {"moving", "moving"}, {"pairs", "pairs"},
                                   {"contacts", "contacts"}, {"depth", "depth"},   {"leaves", "leaves"}};
  for (std::size_t k = 0; k < kPaperContestants; ++k)
    columns.push_back({std::string(paper_name(contestants()[k])) + ", ms", std::string(contestants()[k])});
  columns.push_back({"shows it", "command"});
  page.heading("Simulation " + std::to_string(simulation.number) + ": " + std::string(simulation.title));
  page.table("moments of the first run; times are collision and overhead together", columns, rows);
  page.command(record_command(plan, simulation));
}

/// Two columns of panels; their ids begin with `name`.
void write_columns(Page& page, const std::array<std::vector<CurvePlot>, 2>& columns,
                   const std::vector<Curve>& curves, const std::string& name, const std::string& last_words) {
  std::vector<LegendEntry> legend;
  for (const Curve& curve : curves) legend.push_back({curve_swatch(curve.look), curve.name});
  std::vector<std::string> svgs;
  for (std::size_t row = 0; row < columns[0].size(); ++row)
    for (std::size_t side = 0; side < 2; ++side)
      svgs.push_back(draw(columns[side][row], name + std::to_string(side + 1) + "-" + std::to_string(row)));
  page.figure_of_panels(legend, svgs,
                        "Lines are medians of the steps around a point and of all runs, bands the spread "
                        "over the runs. The pointer shows values" +
                            last_words);
}

void write_figure(Page& page, std::size_t left, const ExperimentRuns& runs) {
  std::array<std::vector<CurvePlot>, 2> columns;
  for (std::size_t side = 0; side < 2; ++side)
    columns[side] = experiment_panels(simulations()[left + side], runs[left + side],
                                      "#" + moment_address(simulations()[left + side], ""));
  write_columns(page, columns, experiment_legend(), "panel" + std::to_string(left) + "-",
                "; a click leads to the moment in the tables below.");
}

Json reading_row(const Reading& reading, const std::vector<TimedRun>& runs) {
  const ReadingCells cells = reading_cells(reading, runs);
  return {{"reading", std::string(reading.label)}, {"leaves", cells.leaves},      {"depth", cells.depth},
          {"change", cells.depth_change},          {"swing", cells.leaves_swing}, {"pairs", cells.pairs},
          {"collision", cells.collision},          {"overhead", cells.overhead}};
}

void write_reading_figures(Page& page, const Simulation& simulation, const std::vector<TimedRun>& runs) {
  Json rows = Json::array();
  for (const Reading& reading : readings()) rows.push_back(reading_row(reading, runs));
  page.table(
      "Simulation " + std::to_string(simulation.number) +
          ": leaves and depth after the first third of the first run, and figures of the first repeats",
      {{"reading", "reading"},
       {"leaves", "leaves"},
       {"depth", "depth"},
       {.title = "change of depth in ten steps", .key = "change", .wraps = true},
       {.title = "leaves, greatest over least fifth", .key = "swing", .wraps = true},
       {"pairs to test", "pairs"},
       {"collision, ms", "collision"},
       {"overhead, ms", "overhead"}},
      rows, {}, true);
}

void write_readings(Page& page, const ExperimentRuns& runs) {
  for (const std::string& paragraph : reading_words()) page.paragraph(paragraph);
  Json counts = Json::array();
  for (const Reading& reading : readings()) {
    const auto [holds, partly, opposite, not_judged] = count_outcomes(judge_all(runs, reading.contestant));
    counts.push_back({{"reading", std::string(reading.label)},
                      {"name", std::string(reading.contestant)},
                      {"words", std::string(reading.words)},
                      {"holds", holds},
                      {"partly", partly},
                      {"opposite", opposite},
                      {"not judged", not_judged}});
  }
  page.table("what each reading is, and how many statements hold with it",
             {{"reading", "reading"},
              {.title = "broad phase", .key = "name", .wraps = true},
              {.title = "the paper's words, and how they are read", .key = "words", .wraps = true},
              {"hold", "holds"},
              {"partly", "partly"},
              {"opposite", "opposite"},
              {.title = "cannot be judged", .key = "not judged", .wraps = true}},
             counts, {}, true);
  for (const std::size_t left : {std::size_t{0}, std::size_t{2}}) {
    std::array<std::vector<CurvePlot>, 2> columns;
    for (std::size_t side = 0; side < 2; ++side)
      columns[side] = reading_panels(simulations()[left + side], runs[left + side]);
    write_columns(page, columns, reading_legend(), "reading" + std::to_string(left) + "-", ".");
  }
  for (std::size_t k = 0; k < runs.size(); ++k) write_reading_figures(page, simulations()[k], runs[k]);
}

Json means_row(const std::vector<TimedRun>& runs, std::string_view contestant) {
  Json row{{"paper", std::string(paper_name(contestant))}, {"name", std::string(contestant)}};
  for (const auto& [key, measure] :
       {std::pair("frames", Measure::frames), std::pair("pairs", Measure::pairs),
        std::pair("collision", Measure::collision), std::pair("overhead", Measure::overhead)}) {
    const auto spread = spread_of(samples_of(runs, contestant, measure));
    row[key] = spread ? text_of(*spread) : "not counted";
  }
  return row;
}

void write_means(Page& page, const Simulation& simulation, const std::vector<TimedRun>& runs) {
  Json rows = Json::array();
  for (const std::string_view name : contestants_in_figures()) rows.push_back(means_row(runs, name));
  page.table("Simulation " + std::to_string(simulation.number) + ": " + std::string(simulation.title) + ", " +
                 std::to_string(runs.front().steps.back().moving) + " moving objects at the end",
             {{"", "paper"},
              {"broad phase", "name"},
              {"frames/s", "frames"},
              {"pairs to test", "pairs"},
              {"collision, ms", "collision"},
              {"overhead, ms", "overhead"}},
             rows, {}, true);
}

/// Found at a glance in a long table.
std::string sign_of(Outcome outcome) {
  constexpr std::array<const char*, 4> kSigns{"\u2714 ", "\u25D0 ", "\u2718 ", "? "};
  return kSigns[static_cast<std::size_t>(outcome)];
}

void write_verdicts(Page& page, const ExperimentRuns& runs) {
  const std::vector<ClaimVerdict> verdicts = judge_all(runs, kPaperTree);
  page.paragraph(count_words(verdicts) + " " + verdict_words());
  Json rows = Json::array();
  for (std::size_t k = 0; k < verdicts.size(); ++k) {
    const Claim& claim = claims()[k];
    rows.push_back({{"simulation", simulation_words(claim)},
                    {"section", std::string(claim.section)},
                    {"words", statement_words(claim)},
                    {"verdict", sign_of(verdicts[k].outcome) + std::string(name_of(verdicts[k].outcome))},
                    {"ours", text_of_standing(verdicts[k])},
                    {"figures", verdicts[k].figures},
                    {"why", verdicts[k].reason}});
  }
  page.table("all statements",
             {{"simulation", "simulation"},
              {"section", "section"},
              {.title = "the paper", .key = "words", .wraps = true},
              {.title = "verdict", .key = "verdict", .wraps = true},
              {.title = "ours", .key = "ours", .wraps = true},
              {.title = "figures", .key = "figures", .wraps = true},
              {.title = "why", .key = "why", .wraps = true}},
             rows, {}, true);
}

void write_wrong(Page& page, const ExperimentRuns& runs) {
  const std::vector<std::string> lines = wrong_words(runs);
  for (const std::string& line : lines) page.paragraph(line);
  page.paragraph(lines.empty()
                     ? "None: all reported the same pairs in every step."
                     : "Boxes and their order are the same for all; the pairs of BSP are held to be true.");
}

}  // namespace

std::string experiment_page(const ExperimentPlan& plan, const ExperimentRuns& runs) {
  Page page(std::string(kExperimentTitle),
            "Figures 12 and 13 of Broad-Phase Collision Detection Using Semi-Adjusting BSP-trees, and what "
            "its sections 6.2 and 7 say of them");
  for (const std::string& paragraph : method_words(plan)) page.paragraph(paragraph);
  page.command(plan.command());
  for (const std::size_t left : {std::size_t{0}, std::size_t{2}}) {
    const std::string number = left == 0 ? "12" : "13";
    page.section("figure-" + number, "Figure " + number);
    write_figure(page, left, runs);
  }
  page.section("means", "Figures");
  for (std::size_t k = 0; k < runs.size(); ++k) write_means(page, simulations()[k], runs[k]);
  page.section("statements", "What the paper says, and what was found");
  write_verdicts(page, runs);
  page.section("readings", "The paper's tree in other readings");
  write_readings(page, first_repeats(runs));
  page.section("wrong", "Wrong answers");
  write_wrong(page, runs);
  page.section("moments", "Moments");
  for (std::size_t k = 0; k < runs.size(); ++k) write_moments(page, plan, simulations()[k], runs[k]);
  return page.html();
}

}  // namespace kerf
