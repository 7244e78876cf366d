#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

#include "core/broad_phase/all_pairs.h"
#include "core/bsp/bsp.h"
#include "core/objects/broad_phase.h"
#include "frames/bench/truth.h"
#include "frames/report/contact_probe.h"
#include "frames/report/figures.h"
#include "frames/report/section.h"
#include "frames/report/setting.h"
#include "frames/report/take.h"
#include "frames/report/trade.h"
#include "frames/rivals/step_timer.h"

namespace kerf {
namespace {

/// Broad phase and narrow phase together, on the motion of a take. The narrow phase tests every candidate
/// again in every step: nothing is remembered of resting pairs.
template <int D>
class TotalCost {
 public:
  /// The take must outlive this. Finds the true contacts of each step.
  TotalCost(const Take<D>& take, const Poll& poll);

  /// {"broad_ns", "narrow_ns", "total_ns" (means), "p99_ns", "max_ns" (of the total): an object and step,
  /// "candidates", "contacts", "missed" (contacts that were no candidates), "missed_share",
  /// "candidates_per_contact"}
  Json run(const std::function<std::unique_ptr<BroadPhase<D>>()>& make, std::uint32_t rounds,
           const Poll& poll);

 private:
  struct Figures;

  void place(std::size_t step);
  void play(BroadPhase<D>& broad_phase, Figures& figures, bool judge, const Poll& poll);
  void begin(BroadPhase<D>& broad_phase);
  [[nodiscard]] std::vector<Pair> test(const BroadPhase<D>& broad_phase) const;

  const Take<D>* take_;
  ContactProbe<D> probe_;
  std::vector<std::vector<Pair>> contacts_;  ///< by step, sorted
};

template <int D>
struct TotalCost<D>::Figures {
  StepTimes broad;
  StepTimes narrow;
  StepTimes total;
  std::uint64_t candidates = 0;
  std::uint64_t contacts = 0;
  std::uint64_t missed = 0;
};

template <int D>
TotalCost<D>::TotalCost(const Take<D>& take, const Poll& poll) : take_(&take) {
  for (const Shape<D>& shape : take.shapes) probe_.add(shape);
  AllPairs<D> oracle;
  begin(oracle);
  for (std::size_t step = 0; step < take.poses.size(); ++step) {
    poll();
    place(step);
    for (std::uint32_t k = 0; k < take.shapes.size(); ++k)
      static_cast<void>(oracle.move({k}, probe_.volume(VolumeKind::box, {k}).box));
    oracle.step();
    contacts_.push_back(test(oracle));
    std::sort(contacts_.back().begin(), contacts_.back().end());
  }
}

template <int D>
void TotalCost<D>::place(std::size_t step) {
  for (std::uint32_t k = 0; k < take_->shapes.size(); ++k) probe_.place({k}, take_->poses[step][k]);
}

template <int D>
void TotalCost<D>::begin(BroadPhase<D>& broad_phase) {
  place(0);
  for (std::uint32_t k = 0; k < take_->shapes.size(); ++k)
    static_cast<void>(
        broad_phase.insert({k}, probe_.volume(broad_phase.volume_kind(), {k}), take_->mobility[k]));
  broad_phase.step();
}

/// The candidates that touch.
template <int D>
std::vector<Pair> TotalCost<D>::test(const BroadPhase<D>& broad_phase) const {
  std::vector<Pair> touching;
  for (const Pair& pair : broad_phase.pairs())
    if (probe_.depth(pair)) touching.push_back(make_pair(pair.a, pair.b));
  return touching;
}

/// Volumes are made before the clock runs: their cost belongs to another section.
template <int D>
void TotalCost<D>::play(BroadPhase<D>& broad_phase, Figures& figures, bool judge, const Poll& poll) {
  figures.broad.restart();
  figures.narrow.restart();
  figures.total.restart();
  begin(broad_phase);
  std::vector<Volume<D>> volumes(take_->shapes.size());
  for (std::size_t step = 1; step < take_->poses.size(); ++step) {
    poll();
    place(step);
    for (std::uint32_t k = 0; k < volumes.size(); ++k)
      volumes[k] = probe_.volume(broad_phase.volume_kind(), {k});
    const StepTimer broad(true);
    for (std::uint32_t k = 0; k < volumes.size(); ++k)
      if (take_->mobility[k] == Mobility::moving) static_cast<void>(broad_phase.move({k}, volumes[k]));
    broad_phase.step();
    const auto broad_ns = static_cast<double>(broad.nanoseconds());
    const StepTimer narrow(true);
    const std::vector<Pair> touching = test(broad_phase);
    const auto narrow_ns = static_cast<double>(narrow.nanoseconds());
    figures.broad.add(broad_ns);
    figures.narrow.add(narrow_ns);
    figures.total.add(broad_ns + narrow_ns);
    if (!judge) continue;
    figures.candidates += broad_phase.pairs().size();
    figures.contacts += contacts_[step].size();
    figures.missed += compare(touching, contacts_[step]).missed;
  }
}

template <int D>
Json TotalCost<D>::run(const std::function<std::unique_ptr<BroadPhase<D>>()>& make, std::uint32_t rounds,
                       const Poll& poll) {
  Figures figures;
  for (std::uint32_t round = 0; round < rounds; ++round) play(*make(), figures, round == 0, poll);
  const auto objects = static_cast<double>(take_->shapes.size());
  const Times total = figures.total.over(objects);
  const double contacts = std::max<double>(1, static_cast<double>(figures.contacts));
  return {{"broad_ns", figures.broad.over(objects).mean},
          {"narrow_ns", figures.narrow.over(objects).mean},
          {"total_ns", total.mean},
          {"total_ns_low", total.round_low},
          {"total_ns_high", total.round_high},
          {"p99_ns", total.p99},
          {"max_ns", total.max},
          {"candidates", figures.candidates},
          {"contacts", figures.contacts},
          {"missed", figures.missed},
          {"missed_share", static_cast<double>(figures.missed) / contacts},
          {"candidates_per_contact", static_cast<double>(figures.candidates) / contacts}};
}

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
  const auto run = [=](const Poll& poll) {
    return dimension == 2 ? measure<2>(scene, sizes, poll) : measure<3>(scene, sizes, poll);
  };
  return make_scene_cell("total", scene, dimension, sizes.scene_objects, sizes, dimension == 2 ? 12 : 28,
                         run);
}

std::vector<SceneCell> scene_cells(const ReportSizes& sizes) {
  return {cell_of("pile", 2, sizes), cell_of("buckets", 2, sizes), cell_of("terrain", 3, sizes),
          cell_of("buckets", 3, sizes)};
}

std::vector<Cell> cells(const ReportRequest& request) { return cells_of(scene_cells(request.sizes)); }

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
  const std::string name = scene.title();
  page.heading(name);
  page.figure(draw(plot_of(rows, kMissed, name + ": time of both phases against missed contacts"),
                   "total-missed-" + scene.id()),
              scene.cell.key + ". Lower left is better; a ring marks the Pareto front.");
  page.figure(draw(plot_of(without_missed(rows), kCandidates,
                           name + ": time of both phases against candidates", rows),
                   "total-candidates-" + scene.id()),
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
