#include "core/base/counted.h"
#include "core/bsp/bsp.h"
#include "frames/report/section.h"
#include "frames/report/setting.h"
#include "frames/report/total_cost.h"
#include "frames/report/trade.h"

namespace kerf {
namespace {

const Trade kMissed{"missed_share", "total_ns", 100, "missed contacts, % of the true ones",
                    "ns an object and step: both phases"};
const Trade kCandidates{"candidates_per_contact", "total_ns", 1, "candidates for each true contact",
                        "ns an object and step: both phases"};

const std::vector<TableColumn> kColumns{{"setting", "setting"},
                                        {"total ns", "total_ns", 1},
                                        {"broad ns", "broad_ns", 1},
                                        {"narrow ns", "narrow_ns", 1},
                                        {"p99 ns", "p99_ns", 1},
                                        {"max ns", "max_ns", 1},
                                        {"candidates per contact", "candidates_per_contact", 2},
                                        {"contacts", "contacts"},
                                        {"missed contacts", "missed"},
                                        {"missed %", "missed_share", 3, 100}};

struct SceneCell {
  std::string scene;
  int dimension = 3;
  Cell cell;
};

template <int D>
Json row_of(TotalCost<D>& cost, const Setting& setting, VolumeKind kind, const ReportSizes& sizes,
            const Poll& poll) {
  Json row{{"setting", setting.name}, {"family", setting.family}};
  row.update(cost.run(
      [&]() -> std::unique_ptr<BroadPhase<D>> {
        if (kind == VolumeKind::box) return make_broad_phase<D>(setting);
        return std::make_unique<Bsp<D>>(setting.config, kind);
      },
      sizes.rounds, poll));
  return row;
}

template <int D>
Json measure(const std::string& scene, const ReportSizes& sizes, const Poll& poll) {
  const Take<D> take = record<D>(scene, {sizes.scene_objects, sizes.scene_objects, sizes.steps}, poll);
  TotalCost<D> cost(take, poll);
  Json rows = Json::array();
  for (const Setting& setting : all_settings())
    rows.push_back(row_of(cost, setting, VolumeKind::box, sizes, poll));
  for (const VolumeKind kind : volume_kinds<D>()) {
    if (kind == VolumeKind::box) continue;
    const Setting setting{std::string(to_string(kind)), "exact: other volumes", tuned_config(), {}};
    rows.push_back(row_of(cost, setting, kind, sizes, poll));
  }
  return rows;
}

SceneCell cell_of(const std::string& scene, int dimension, const ReportSizes& sizes) {
  const std::string key = "total " + scene + " " + std::to_string(dimension) + "D, " +
                          std::to_string(sizes.scene_objects) + " objects, " + std::to_string(sizes.steps) +
                          " steps, " + counted(sizes.rounds, "round");
  const auto run = [=](const Poll& poll) {
    return dimension == 2 ? measure<2>(scene, sizes, poll) : measure<3>(scene, sizes, poll);
  };
  return {scene, dimension, {key, run, work_of(dimension == 2 ? 12 : 28, sizes.scene_objects, sizes.steps)}};
}

std::vector<SceneCell> scene_cells(const ReportSizes& sizes) {
  return {cell_of("pile", 2, sizes), cell_of("buckets", 2, sizes), cell_of("terrain", 3, sizes),
          cell_of("buckets", 3, sizes)};
}

std::vector<Cell> cells(const ReportRequest& request) {
  std::vector<Cell> all;
  for (SceneCell& scene : scene_cells(request.sizes)) all.push_back(std::move(scene.cell));
  return all;
}

void write_recommendations(const std::vector<SceneCell>& scenes, const CellStore& store, Page& page) {
  Json rows = Json::array();
  for (const SceneCell& scene : scenes) {
    const Json& all = store.at(scene.cell.key);
    const Json best = recommended_within(all, kMissed, 0);
    rows.push_back({{"scene", scene.scene + ", " + std::to_string(scene.dimension) + "D"},
                    {"setting", best["setting"]},
                    {"total_ns", best["total_ns"]},
                    {"broad_ns", best["broad_ns"]},
                    {"kerf_ns", all[0]["total_ns"]}});
  }
  page.heading("Recommended settings");
  page.table("the fastest that missed no contact, by scene; kerf as it is where nothing gains a twentieth",
             {{"scene", "scene"},
              {"setting", "setting"},
              {"both phases ns", "total_ns", 1},
              {"broad ns", "broad_ns", 1},
              {"kerf as it is ns", "kerf_ns", 1}},
             rows, {}, true);
}

Json without_missed(const Json& rows) {
  Json complete = Json::array();
  for (const Json& row : rows)
    if (row.at("missed") == 0) complete.push_back(row);
  return complete;
}

void write_scene(const SceneCell& scene, const CellStore& store, Page& page) {
  const Json& rows = store.at(scene.cell.key);
  const std::string name = scene.scene + " in " + std::to_string(scene.dimension) + "D";
  const std::string id = scene.scene + std::to_string(scene.dimension);
  page.heading(name);
  page.figure(draw(plot_of(rows, kMissed, name + ": time of both phases against missed contacts"),
                   "total-missed-" + id),
              scene.cell.key + ". Lower left is better; a ring marks the Pareto front.");
  page.figure(draw(plot_of(without_missed(rows), kCandidates,
                           name + ": time of both phases against candidates", rows),
                   "total-candidates-" + id),
              "Those of the same runs that missed no contact. Where fewer candidates pay, what is farther "
              "left is lower.");
  page.table("all settings of these plots", kColumns, rows, front_of(rows, kMissed));
}

void write(const ReportRequest& request, const CellStore& store, Page& page) {
  page.paragraph(
      "Scenes recorded once with the exact broad phase; then every setting sees the same motion, and the "
      "narrow phase (Box2D's manifolds, ODE's colliders) tests all of its candidates anew. Contacts are "
      "those among all pairs by brute force. Making the volumes is not counted here.");
  const std::vector<SceneCell> scenes = scene_cells(request.sizes);
  write_recommendations(scenes, store, page);
  for (const SceneCell& scene : scenes) write_scene(scene, store, page);
  page.command(command_of(request, "total"));
}

}  // namespace

Section total_section() { return {"total", "Broad phase and narrow phase together", cells, write}; }

}  // namespace kerf
