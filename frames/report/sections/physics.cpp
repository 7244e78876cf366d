#include <algorithm>
#include <cmath>

#include "core/base/median.h"
#include "frames/report/figures.h"
#include "frames/report/loop_cells.h"
#include "frames/report/section.h"
#include "frames/report/trade.h"

namespace kerf {
namespace {

const Trade kDepth{"depth", "mean_ns", 1, "deepest penetration, units of the scene",
                   "ns an object and step, mean: broad phase"};
const Trade kDrift{"drift", "mean_ns", 1, "energy away from the exact run's, units of height",
                   "ns an object and step, mean: broad phase"};

const std::vector<TableColumn> kColumns{{"setting", "setting"},
                                        {"mean ns", "mean_ns", 1},
                                        {"deepest penetration", "depth", 3},
                                        {"of all seeds", "depth_max", 3},
                                        {"energy drift", "drift", kShortestDigits},
                                        {"signed", "signed_drift", kShortestDigits},
                                        {"energy", "energy", 3}};

/// The mean of a list of one run over its last quarter.
double late_mean(const Json& run, const char* key) {
  const auto numbers = run.at(key).get<std::vector<double>>();
  const std::size_t first = numbers.size() * 3 / 4;
  double sum = 0;
  for (std::size_t k = first; k < numbers.size(); ++k) sum += numbers[k];
  return sum / static_cast<double>(numbers.size() - first);
}

double largest(const Json& run, const char* key) {
  const auto numbers = run.at(key).get<std::vector<double>>();
  return *std::max_element(numbers.begin(), numbers.end());
}

/// The median and the quartiles of the seeds.
void add_spread(Json& row, const std::string& key, const std::vector<double>& seeds) {
  row[key] = median(seeds);
  row[low_key(key)] = quantile(seeds, 0.25);
  row[high_key(key)] = quantile(seeds, 0.75);
}

Json row_of(const LoopRuns& runs, const LoopRuns& exact) {
  std::vector<double> times;
  std::vector<double> depths;
  std::vector<double> energies;
  std::vector<double> drifts;
  std::vector<double> signed_drifts;
  for (std::size_t seed = 0; seed < runs.seeds.size(); ++seed) {
    times.push_back(runs.seeds[seed].at("mean_ns").get<double>());
    depths.push_back(largest(runs.seeds[seed], "depth"));
    energies.push_back(late_mean(runs.seeds[seed], "energy"));
    signed_drifts.push_back(energies.back() - late_mean(exact.seeds[seed], "energy"));
    drifts.push_back(std::abs(signed_drifts.back()));
  }
  Json row{{"setting", runs.setting}, {"family", runs.family}};
  add_spread(row, "mean_ns", times);
  add_spread(row, "depth", depths);
  add_spread(row, "drift", drifts);
  row.update({{"depth_max", *std::max_element(depths.begin(), depths.end())},
              {"signed_drift", median(signed_drifts)},
              {"energy", median(energies)}});
  return row;
}

void write_scene(const LoopScene& scene, const CellStore& store, Page& page) {
  const std::vector<LoopRuns> settings = runs_by_setting(scene, store);
  Json rows = Json::array();
  for (const LoopRuns& runs : settings) rows.push_back(row_of(runs, settings.front()));
  const std::string name = scene.scene + " in " + std::to_string(scene.dimension) + "D";
  const std::string id = scene.scene + std::to_string(scene.dimension);
  const std::string of = scene.seeds.front().key + " to " + std::to_string(scene.seeds.size());
  page.heading(name);
  page.figure(draw(plot_of(rows, kDepth, name + ": time against penetration"), "depth-" + id),
              of + ", medians and quartiles of seeds. Also exact runs penetrate: solvers let contacts sink.");
  page.figure(draw(plot_of(rows, kDrift, name + ": time against energy drift"), "drift-" + id),
              "The same runs. The control (one ulp aside) shows what chaos alone does to the energy.");
  page.table("all settings of these plots", kColumns, rows, front_of(rows, kDepth), true);
}

std::vector<Cell> cells(const ReportRequest& request) { return cells_of(loop_scenes(request.sizes)); }

void write(const ReportRequest& request, const CellStore& store, Page& page) {
  page.paragraph(
      "What wrong pairs do to the physics, in the runs of the section before. Penetration is the deepest "
      "that any two bodies were in each other at the steps that were looked at, by the engine's own narrow "
      "phase. Energy is kinetic (of the middles, without spin) and potential, over weight, so that it is a "
      "height; the drift is how far its mean over the last quarter lies from that of the exact run of the "
      "same seed. Both engines damp: energy falls in every run. What falls through a floor goes on falling "
      "in 2D, and is put back above the scene in 3D.");
  for (const LoopScene& scene : loop_scenes(request.sizes)) write_scene(scene, store, page);
  page.command(command_of(request, "physics"));
}

}  // namespace

Section physics_section() { return {"physics", "Energy drift and penetration", cells, write}; }

}  // namespace kerf
