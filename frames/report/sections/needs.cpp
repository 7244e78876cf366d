#include <algorithm>

#include "core/base/counted.h"
#include "frames/page/plot.h"
#include "frames/report/need_cost.h"
#include "frames/report/section.h"

namespace kerf {
namespace {

struct NeedsCell {
  std::string scene;
  int dimension = 3;
  Cell cell;
};

template <int D>
Json measure(const std::string& scene, const ReportSizes& sizes, const Poll& poll) {
  constexpr std::uint32_t kGrow = 500;
  const std::uint32_t objects = sizes.need_objects;
  const Take<D> take = record<D>(scene, {objects, std::min(objects, kGrow), sizes.steps}, poll);
  Json rows = Json::array();
  for (const Model& model : models<D>()) rows.push_back(run_model(take, model, sizes.rounds, poll));
  const double least = rows[0]["mean_ns"].template get<double>();
  for (Json& row : rows) row["times_least"] = row["mean_ns"].template get<double>() / least;
  return rows;
}

NeedsCell cell_of(const std::string& scene, int dimension, const ReportSizes& sizes) {
  const std::string key = "needs " + scene + " " + std::to_string(dimension) + "D, " +
                          std::to_string(sizes.need_objects) + " objects, " + std::to_string(sizes.steps) +
                          " steps, " + counted(sizes.rounds, "round");
  const auto run = [=](const Poll& poll) {
    return dimension == 2 ? measure<2>(scene, sizes, poll) : measure<3>(scene, sizes, poll);
  };
  return {scene, dimension, {key, run, work_of(6, sizes.need_objects, sizes.steps)}};
}

std::vector<NeedsCell> needs_cells(const ReportSizes& sizes) {
  return {cell_of("pile", 2, sizes), cell_of("buckets", 3, sizes)};
}

std::vector<Cell> cells(const ReportRequest& request) {
  std::vector<Cell> all;
  for (NeedsCell& needs : needs_cells(request.sizes)) all.push_back(std::move(needs.cell));
  return all;
}

void write_scene(const NeedsCell& needs, const CellStore& store, Page& page) {
  const Json& rows = store.at(needs.cell.key);
  const std::string name = needs.scene + " in " + std::to_string(needs.dimension) + "D";
  BarPlot plot{name + ": what each need costs, switched on alone", "ns a moving object and step, mean", {}};
  for (const Json& row : rows)
    plot.bars.push_back(
        {row.at("need").get<std::string>(), row.at("mean_ns").get<double>(), row.value("mean_ns_high", 0.0)});
  page.heading(name);
  page.figure(draw(plot, "needs-" + needs.scene + std::to_string(needs.dimension)), needs.cell.key);
  page.table("all needs of this plot",
             {{"modelled", "need"},
              {"mean ns", "mean_ns", 1},
              {"times the least", "times_least", 2},
              {"median ns", "median_ns", 1},
              {"p99 ns", "p99_ns", 1},
              {"max ns", "max_ns", 1},
              {"candidates an object", "candidates", 2}},
             rows, {}, true);
}

void write(const ReportRequest& request, const CellStore& store, Page& page) {
  page.paragraph(
      "A scene states its needs and pays for nothing else. The least model has boxes that keep their shape, "
      "moving objects alone, partitioners along the axes, and reports pairs; every other bar adds one need "
      "to it. The motion is that of a recorded scene. Time is that of bounding and broad phase, and of the "
      "narrow phase where contacts are wanted. A third axis puts the flat scene into a tree of three "
      "dimensions, in which the new axis separates nothing.");
  for (const NeedsCell& needs : needs_cells(request.sizes)) write_scene(needs, store, page);
  page.command(command_of(request, "needs"));
}

}  // namespace

Section needs_section() { return {"needs", "What each need costs", cells, write}; }

}  // namespace kerf
