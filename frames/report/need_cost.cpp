#include "frames/report/need_cost.h"

#include <algorithm>
#include <utility>

#include "core/bsp/bsp.h"
#include "core/scene/bounding.h"
#include "frames/report/contact_probe.h"
#include "frames/report/figures.h"
#include "frames/rivals/step_timer.h"

namespace kerf {
namespace {

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

}  // namespace

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

template <int D>
Json run_model(const Take<D>& take, const Model& model, std::uint32_t rounds, const Poll& poll) {
  if constexpr (D == 2)
    if (model.third_axis) return run_in<2, 3>(take, model, rounds, poll);
  return run_in<D, D>(take, model, rounds, poll);
}

template std::vector<Model> models<2>();
template std::vector<Model> models<3>();
template Json run_model(const Take<2>&, const Model&, std::uint32_t, const Poll&);
template Json run_model(const Take<3>&, const Model&, std::uint32_t, const Poll&);

}  // namespace kerf
