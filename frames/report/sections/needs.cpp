#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/bsp/bsp.h"
#include "core/scene/bounding.h"
#include "frames/page/plot.h"
#include "frames/report/contact_probe.h"
#include "frames/report/figures.h"
#include "frames/report/section.h"
#include "frames/report/take.h"
#include "frames/rivals/step_timer.h"

namespace kerf {
namespace {

/// The modelled needs of a scene; by default the least: boxes that do not turn, of objects that all move,
/// partitioners along the axes, pairs only.
struct Model {
  std::string need;  ///< the need that it adds to the least model
  bool third_axis = false;
  bool fixed_objects = false;
  bool rotation = false;
  bool free_directions = false;
  bool contacts = false;
  VolumeKind volume = VolumeKind::box;
};

constexpr double kMargin = 0.01;  ///< as the 2D scenes have it

/// A volume in W dimensions of one in D: a flat one gets a depth of 1.
template <int W, int D>
Volume<W> lifted(const Volume<D>& volume) {
  if constexpr (W == D) {
    return volume;
  } else {
    Volume<W> result;
    for (int i = 0; i < D; ++i) {
      result.box.min[i] = volume.box.min[i];
      result.box.max[i] = volume.box.max[i];
    }
    result.box.min[D] = -0.5F;
    result.box.max[D] = 0.5F;
    return result;
  }
}

Config config_of(const Model& model) {
  Config config = tuned_config();
  config.free_directions = model.free_directions;
  return config;
}

/// A take of D dimensions in a broad phase of W, as modelled.
template <int D, int W>
class ModelRun {
 public:
  ModelRun(const Take<D>& take, const Model& model)
      : take_(take), model_(model), broad_phase_(config_of(model), model.volume) {
    for (std::uint32_t k = 0; k < take.shapes.size(); ++k) {
      probe_.add(take.shapes[k]);
      const bool moves = take.mobility[k] == Mobility::moving;
      if (moves) moving_.push_back({k});
      volumes_.push_back(bounded({k}, 0, true));
      if (moves || model.fixed_objects)
        static_cast<void>(broad_phase_.insert({k}, lifted<W>(volumes_[k]), take.mobility[k]));
    }
    broad_phase_.step();
  }

  void go(StepTimes& times, const Poll& poll) {
    times.restart();
    for (std::size_t step = 1; step < take_.poses.size(); ++step) {
      poll();
      if (model_.contacts) place(step);
      const StepTimer timer(true);
      for (const ObjectId object : moving_)
        static_cast<void>(broad_phase_.move(object, lifted<W>(volume_at(object, step))));
      broad_phase_.step();
      if (model_.contacts) test();
      times.add(static_cast<double>(timer.nanoseconds()));
      candidates_ += broad_phase_.pairs().size();
    }
  }
  [[nodiscard]] double candidates_an_object() const {
    return static_cast<double>(candidates_) / moving() / static_cast<double>(take_.poses.size() - 1);
  }
  [[nodiscard]] double moving() const { return static_cast<double>(moving_.size()); }
  [[nodiscard]] std::uint64_t touches() const { return touches_; }

 private:
  [[nodiscard]] Volume<D> bounded(ObjectId object, std::size_t step, bool turned) const {
    Pose<D> pose = take_.poses[step][object.index()];
    if (!turned) pose.axes = take_.poses[0][object.index()].axes;
    return bound<D>(model_.volume, take_.shapes[object.index()], precise(pose), kMargin);
  }
  /// An object that does not turn keeps its box, which moves with it.
  [[nodiscard]] Volume<D> volume_at(ObjectId object, std::size_t step) const {
    if (model_.rotation || model_.volume != VolumeKind::box) return bounded(object, step, model_.rotation);
    Volume<D> volume = volumes_[object.index()];
    const Vector<D> way =
        take_.poses[step][object.index()].position - take_.poses[0][object.index()].position;
    volume.box = {volume.box.min + way, volume.box.max + way};
    return volume;
  }
  void place(std::size_t step) {
    for (const ObjectId object : moving_) probe_.place(object, take_.poses[step][object.index()]);
  }
  void test() {
    for (const Pair& pair : broad_phase_.pairs()) touches_ += probe_.depth(pair) ? 1 : 0;
  }

  const Take<D>& take_;
  const Model& model_;
  Bsp<W> broad_phase_;
  ContactProbe<D> probe_;
  std::vector<ObjectId> moving_;
  std::vector<Volume<D>> volumes_;  ///< at the first step
  std::uint64_t candidates_ = 0;
  std::uint64_t touches_ = 0;
};

template <int D, int W>
Json run_in(const Take<D>& take, const Model& model, std::uint32_t rounds, const Poll& poll) {
  StepTimes times;
  Json row{{"need", model.need}};
  for (std::uint32_t round = 0; round < rounds; ++round) {
    ModelRun<D, W> run(take, model);
    run.go(times, poll);
    row.update(as_json(times.over(run.moving())));
    row["candidates"] = run.candidates_an_object();
    row["touches"] = run.touches();
  }
  return row;
}

/// The least model, each need of D dimensions switched on alone, and all of them. Only 2D can add a third
/// axis.
template <int D>
std::vector<Model> models() {
  std::vector<Model> all{{.need = "the least"}};
  if constexpr (D == 2) all.push_back({.need = "a third axis", .third_axis = true});
  all.push_back({.need = "fixed objects", .fixed_objects = true});
  all.push_back({.need = "rotation", .rotation = true});
  all.push_back({.need = "free directions", .free_directions = true});
  for (const VolumeKind kind : volume_kinds<D>())
    if (kind != VolumeKind::box)
      all.push_back({.need = "volume: " + std::string(to_string(kind)), .volume = kind});
  all.push_back({.need = "contacts", .contacts = true});
  all.push_back({.need = "all, with boxes",
                 .fixed_objects = true,
                 .rotation = true,
                 .free_directions = true,
                 .contacts = true});
  return all;
}

/// Runs a take as modelled: {"need", "mean_ns", "median_ns", "p99_ns", "max_ns" (a moving object and step:
/// bounding, broad phase and, if it is modelled, narrow phase), "candidates" (a moving object and step)}.
template <int D>
Json run_model(const Take<D>& take, const Model& model, std::uint32_t rounds, const Poll& poll) {
  if constexpr (D == 2)
    if (model.third_axis) return run_in<2, 3>(take, model, rounds, poll);
  return run_in<D, D>(take, model, rounds, poll);
}

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

SceneCell cell_of(const std::string& scene, int dimension, const ReportSizes& sizes) {
  const auto run = [=](const Poll& poll) {
    return dimension == 2 ? measure<2>(scene, sizes, poll) : measure<3>(scene, sizes, poll);
  };
  return make_scene_cell("needs", scene, dimension, sizes.need_objects, sizes, 6, run);
}

std::vector<SceneCell> needs_cells(const ReportSizes& sizes) {
  return {cell_of("pile", 2, sizes), cell_of("buckets", 3, sizes)};
}

std::vector<Cell> cells(const ReportRequest& request) { return cells_of(needs_cells(request.sizes)); }

void write_scene(const SceneCell& needs, const CellStore& store, Page& page) {
  const Json& rows = store.at(needs.cell.key);
  BarPlot plot{
      needs.title() + ": what each need costs, switched on alone", "ns a moving object and step, mean", {}};
  for (const Json& row : rows)
    plot.bars.push_back(
        {row.at("need").get<std::string>(), row.at("mean_ns").get<double>(), row.value("mean_ns_high", 0.0)});
  page.heading(needs.title());
  page.figure(draw(plot, "needs-" + needs.id()), needs.cell.key);
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
  for (const SceneCell& needs : needs_cells(request.sizes)) write_scene(needs, store, page);
  page.command(command_of(request, "needs"));
}

}  // namespace

Section needs_section() { return {"needs", "What each need costs", cells, write}; }

}  // namespace kerf
