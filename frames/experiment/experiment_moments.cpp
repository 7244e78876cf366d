#include "frames/experiment/experiment_moments.h"

#include "frames/catalog/scene_catalog.h"
#include "frames/experiment/experiment_panels.h"
#include "frames/experiment/spread.h"
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

}  // namespace

std::string moment_address(const Simulation& simulation, const std::string& step) {
  return "moment-" + std::to_string(simulation.number) + "-" + step;
}

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

}  // namespace kerf
