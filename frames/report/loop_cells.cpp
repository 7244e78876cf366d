#include "frames/report/loop_cells.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <numeric>
#include <string_view>
#include <utility>

#include "core/objects/broad_phase.h"
#include "frames/page/cell.h"
#include "frames/report/figures.h"
#include "frames/report/mechanics.h"
#include "frames/report/setting.h"
#include "frames/report/take.h"
#include "frames/rivals/step_timer.h"

namespace kerf {
namespace {

/// A broad phase that measures the time of its `step()`.
template <int D>
class Stopwatch final : public BroadPhase<D> {
 public:
  explicit Stopwatch(std::unique_ptr<BroadPhase<D>> inner) : inner_(std::move(inner)) {}

  [[nodiscard]] std::string_view name() const override { return inner_->name(); }
  using BroadPhase<D>::insert;
  using BroadPhase<D>::move;
  Status insert(ObjectId object, const Box<D>& box, Mobility mobility) override {
    return inner_->insert(object, box, mobility);
  }
  Status move(ObjectId object, const Box<D>& box) override { return inner_->move(object, box); }
  Status move_many(std::span<const ObjectId> objects, std::span<const Box<D>> boxes) override {
    return inner_->move_many(objects, boxes);
  }
  Status remove(ObjectId object) override { return inner_->remove(object); }
  void step() override {
    const StepTimer timer(true);
    inner_->step();
    nanoseconds_ = static_cast<double>(timer.nanoseconds());
  }
  [[nodiscard]] std::span<const Pair> pairs() const override { return inner_->pairs(); }
  /// Of the last step.
  [[nodiscard]] double nanoseconds() const { return nanoseconds_; }

 private:
  std::unique_ptr<BroadPhase<D>> inner_;
  double nanoseconds_ = 0;
};

constexpr std::uint32_t kSamples = 40;

template <int D>
std::vector<Vector<D>> positions_of(std::span<const Body<D>> bodies) {
  std::vector<Vector<D>> positions;
  for (const Body<D>& body : bodies) positions.push_back(body.pose.position);
  return positions;
}

/// The steps after which a run is sampled.
std::vector<std::uint32_t> sampled_steps(const SceneLength& length) {
  const std::uint32_t last = length.grow + length.steps;
  std::vector<std::uint32_t> steps;
  for (std::uint32_t k = 1; k <= kSamples; ++k) steps.push_back(std::max(2U, last * k / kSamples));
  steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
  return steps;
}

/// One run of the scene, sampled after each of the steps.
template <int D>
class Run {
 public:
  Run(std::string_view scene, const SceneLength& length, std::uint64_t seed, std::uint32_t nudge,
      const Setting& setting)
      : broad_phase_(make_broad_phase<D>(setting)),
        scene_(scene_entry<D>(scene).make(
            broad_phase_, {.objects = length.objects, .steps = length.grow, .seed = seed, .nudge = nudge})) {}

  /// `reference` has the positions in the exact run by sample; an empty one becomes this run's.
  void go(std::span<const std::uint32_t> steps, std::vector<std::vector<Vector<D>>>& reference,
          const Poll& poll) {
    for (std::size_t k = 0; k < steps.size(); ++k) {
      std::vector<Vector<D>> before;
      while (scene_->step() < steps[k]) {
        poll();
        before = positions_of(scene_->bodies());
        scene_->advance();
        times_.add(broad_phase_.nanoseconds() / static_cast<double>(scene_->bodies().size()));
      }
      if (k == reference.size()) reference.push_back(positions_of(scene_->bodies()));
      look(before, reference[k]);
    }
  }
  [[nodiscard]] Json figures(const std::string& name, const std::string& family) const {
    return {{"setting", name},       {"family", family},  {"mean_ns", times_.over(1).mean},
            {"distance", distance_}, {"energy", energy_}, {"depth", depth_}};
  }

 private:
  void look(const std::vector<Vector<D>>& before, const std::vector<Vector<D>>& reference) {
    distance_.push_back(distance_of_runs<D>(scene_->bodies(), reference));
    energy_.push_back(energy_height<D>(scene_->bodies(), before));
    depth_.push_back(deepest_penetration<D>(scene_->bodies()));
  }

  Stopwatch<D> broad_phase_;
  std::unique_ptr<Scene<D>> scene_;  ///< after the broad phase, which it uses to its end
  StepTimes times_;
  std::vector<double> distance_;
  std::vector<double> energy_;
  std::vector<double> depth_;
};

/// Runs a scene in which the pairs decide the motion, from one seed: with the exact broad phase, as the
/// reference, and once more; with the paper's, which reports the same pairs; with the first object moved
/// aside by one ulp (the control, which shows how chaotic the scene itself is); and with each of
/// `few_settings()`.
///
/// {"steps": [...], "runs": [{"setting", "family", "mean_ns" (of the broad phase, an object and step),
/// "distance": [...], "energy": [...], "depth": [...]}, ...]}: at each of the steps how far objects are from
/// their positions in the exact run (root of the mean square, units of the scene), the height of energy, and
/// the deepest penetration.
template <int D>
Json run_closed_loops(std::string_view scene, const SceneLength& length, std::uint64_t seed,
                      const Poll& poll) {
  const std::vector<std::uint32_t> steps = sampled_steps(length);
  std::vector<std::vector<Vector<D>>> reference;
  Json runs = Json::array();
  const auto run_with = [&](std::uint32_t nudge, const Setting& setting) {
    Run<D> run(scene, length, seed, nudge, setting);
    run.go(steps, reference, poll);
    return run.figures(nudge == 0 ? setting.name : "one ulp aside", setting.family);
  };
  const Setting exact{"kerf", "exact", tuned_config(), {}};
  run_with(0, exact);  // the reference; its times are those of a cold machine
  runs.push_back(run_with(0, exact));
  runs.push_back(run_with(0, {"kerf-paper", "exact", Config{}, {}}));
  runs.push_back(run_with(1, {"kerf", "control", tuned_config(), {}}));
  for (const Setting& setting : few_settings()) runs.push_back(run_with(0, setting));
  return {{"steps", steps}, {"runs", std::move(runs)}};
}

Cell cell_of(const std::string& scene, int dimension, const ReportSizes& sizes, std::uint64_t seed) {
  const std::uint32_t grow = sizes.loop_steps * 2 / 5;
  const SceneLength length{sizes.loop_objects, grow, sizes.loop_steps - grow};
  const std::string key = "loop " + scene + " " + std::to_string(dimension) + "D, " +
                          std::to_string(length.objects) + " objects, " + std::to_string(sizes.loop_steps) +
                          " steps, seed " + std::to_string(seed);
  const auto run = [=](const Poll& poll) {
    return dimension == 2 ? run_closed_loops<2>(scene, length, seed, poll)
                          : run_closed_loops<3>(scene, length, seed, poll);
  };
  return {key, run, work_of(dimension == 2 ? 3 : 6, length.objects, sizes.loop_steps)};
}

LoopScene loop_scene(const std::string& scene, int dimension, const ReportSizes& sizes) {
  LoopScene loop{scene, dimension, {}};
  for (std::uint64_t seed = 1; seed <= sizes.seeds; ++seed)
    loop.seeds.push_back(cell_of(scene, dimension, sizes, seed));
  return loop;
}

}  // namespace

std::vector<LoopScene> loop_scenes(const ReportSizes& sizes) {
  return {loop_scene("pile", 2, sizes), loop_scene("buckets", 2, sizes), loop_scene("terrain", 3, sizes),
          loop_scene("buckets", 3, sizes)};
}

std::vector<Cell> cells_of(const std::vector<LoopScene>& scenes) {
  std::vector<Cell> cells;
  for (const LoopScene& scene : scenes) cells.insert(cells.end(), scene.seeds.begin(), scene.seeds.end());
  return cells;
}

std::vector<LoopRuns> runs_by_setting(const LoopScene& scene, const CellStore& store) {
  std::vector<LoopRuns> settings;
  for (const Cell& cell : scene.seeds) {
    const Json& result = store.at(cell.key);
    const Json& runs = result.at("runs");
    settings.resize(runs.size());
    for (std::size_t k = 0; k < runs.size(); ++k) {
      settings[k].setting = runs[k].at("setting").get<std::string>();
      settings[k].family = runs[k].at("family").get<std::string>();
      settings[k].steps = result.at("steps").get<std::vector<double>>();
      settings[k].seeds.push_back(runs[k]);
    }
  }
  return settings;
}

}  // namespace kerf
