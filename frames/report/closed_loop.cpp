#include "frames/report/closed_loop.h"

#include <algorithm>
#include <numeric>

#include "frames/report/figures.h"
#include "frames/report/mechanics.h"
#include "frames/report/setting.h"
#include "frames/report/stopwatch.h"

namespace kerf {
namespace {

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

}  // namespace

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

template Json run_closed_loops<2>(std::string_view, const SceneLength&, std::uint64_t, const Poll&);
template Json run_closed_loops<3>(std::string_view, const SceneLength&, std::uint64_t, const Poll&);

}  // namespace kerf
