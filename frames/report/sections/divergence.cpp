#include <algorithm>

#include "core/base/median.h"
#include "frames/page/plot.h"
#include "frames/report/figures.h"
#include "frames/report/loop_cells.h"
#include "frames/report/section.h"
#include "frames/report/trade.h"

namespace kerf {
namespace {

/// The distances of all seeds at one of the steps.
std::vector<double> at_sample(const LoopRuns& runs, std::size_t sample) {
  std::vector<double> distances;
  for (const Json& run : runs.seeds) distances.push_back(run.at("distance").at(sample).get<double>());
  return distances;
}

/// The first step at which half of the seeds are farther apart than `distance`; -1: never.
double parted_at(const LoopRuns& runs, double distance) {
  for (std::size_t k = 0; k < runs.steps.size(); ++k)
    if (median(at_sample(runs, k)) > distance) return runs.steps[k];
  return -1;
}

Json row_of(const LoopRuns& runs) {
  const std::vector<double> last = at_sample(runs, runs.steps.size() - 1);
  Json row{{"setting", runs.setting},
           {"median", median(last)},
           {"low", quantile(last, 0.25)},
           {"high", quantile(last, 0.75)},
           {"seeds", last.size()}};
  const double parted = parted_at(runs, 0.1);
  row["parted"] = parted < 0 ? Json("never") : Json(parted);
  return row;
}

/// The median of the seeds and its quartiles.
PlotPoint point_at(const LoopRuns& runs, std::size_t sample) {
  const std::vector<double> distances = at_sample(runs, sample);
  PlotPoint point{runs.steps[sample], median(distances)};
  point.y_range = {quantile(distances, 0.25), quantile(distances, 0.75)};
  return point;
}

PlotSeries series_of(const LoopRuns& runs) {
  constexpr int kBlack = 7;
  const bool is_control = runs.family == kControl;
  PlotSeries series{short_name(runs.setting),
                    {},
                    is_control ? PlotStyle::dashed : PlotStyle::line,
                    is_control ? kBlack : -1};
  for (std::size_t k = 0; k < runs.steps.size(); ++k) series.points.push_back(point_at(runs, k));
  return series;
}

void write_scene(const LoopScene& scene, const CellStore& store, Page& page) {
  const std::string name = scene.scene + " in " + std::to_string(scene.dimension) + "D";
  Plot plot{name + ": distance from the exact run, median and quartiles of seeds",
            "step",
            "units of the scene, root mean square",
            false,
            true,
            {}};
  Json rows = Json::array();
  for (const LoopRuns& runs : runs_by_setting(scene, store)) {
    plot.series.push_back(series_of(runs));
    rows.push_back(row_of(runs));
  }
  page.heading(name);
  page.figure(draw(plot, "divergence-" + scene.scene + std::to_string(scene.dimension)),
              scene.seeds.front().key + " to " + std::to_string(scene.seeds.size()) +
                  ". The dashed control shows how chaotic the scene is by itself: a run is as good as exact "
                  "while it stays near the control.");
  page.table("distances after the last step, units of the scene",
             {{"setting", "setting"},
              {"lower quartile", "low", kShortestDigits},
              {"median", "median", kShortestDigits},
              {"upper quartile", "high", kShortestDigits},
              {"step of 0.1 units", "parted"},
              {"seeds", "seeds"}},
             rows, {}, true);
}

std::vector<Cell> cells(const ReportRequest& request) { return cells_of(loop_scenes(request.sizes)); }

void write(const ReportRequest& request, const CellStore& store, Page& page) {
  page.paragraph(
      "Scenes in which the broad phase's pairs decide what collides, compared step by step with the run of "
      "the exact broad phase from the same seed. The second run of kerf, and the paper's configuration, "
      "report the same pairs, so their distance is 0 to the last bit; the control differs by one ulp in "
      "where the first object starts. Extra pairs alone leave ODE's runs as they are, but change the order "
      "in which Box2D solves contacts. Objects are about one unit large.");
  for (const LoopScene& scene : loop_scenes(request.sizes)) write_scene(scene, store, page);
  page.command(command_of(request, "divergence"));
}

}  // namespace

Section divergence_section() { return {"divergence", "Divergence of trajectories", cells, write}; }

}  // namespace kerf
