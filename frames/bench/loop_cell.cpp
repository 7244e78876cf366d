#include "frames/bench/loop_cell.h"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>
#include <variant>

#include "core/base/median.h"
#include "core/bsp/bsp.h"
#include "core/recording/recorder.h"
#include "frames/bench/loop_watch.h"
#include "frames/catalog/broad_phase_choice.h"
#include "frames/support/scratch_folder.h"

namespace kerf {
namespace {

/// Steps that the scene does before the broad phase alone is given them all.
constexpr std::uint32_t kBlock = 16;

/// The broad phase that stands in the loop of `kerf render` and `kerf record`.
template <int D>
class InLoop {
 public:
  InLoop(const BroadPhaseChoice& choice, const SceneEntry<D>& entry, const SceneOptions& options) {
    if (choice.is_tree()) {
      tree_ = std::make_unique<Bsp<D, EventLog>>(choice.config, choice.volume);
      RecordingInfo info;
      info.dimension = D;
      info.volume = choice.volume;
      info.config = choice.config;
      recorder_ = std::make_unique<Recorder<D>>(*tree_, folder_.path() / "loop.kerf", info);
    } else {
      other_ = make_broad_phase<D>(choice, entry, options);
    }
  }

  [[nodiscard]] BroadPhase<D>& broad_phase() { return recorder_ ? *recorder_ : *other_; }
  [[nodiscard]] double recording_seconds() const { return recorder_ ? recorder_->seconds() : 0; }
  /// The recording has the events already.
  void forget_events() {
    if (tree_) (void)tree_->trace().take();
  }

 private:
  ScratchFolder folder_;
  std::unique_ptr<Bsp<D, EventLog>> tree_;
  std::unique_ptr<Recorder<D>> recorder_;
  std::unique_ptr<BroadPhase<D>> other_;
};

constexpr double kNever = 1e300;

/// Of one step, in nanoseconds; the least of all rounds.
struct StepCost {
  double loop = kNever;
  double simulation = kNever;  ///< all that the scene does in the step
};

std::vector<double> per_object(std::vector<double> values, std::uint32_t objects) {
  for (double& value : values) value /= objects;
  return values;
}

/// A broad phase that is given the requests of a simulation, and its measurements so far.
template <int D>
class Alone {
 public:
  Alone(std::string name, const LoopPlan& plan, const SceneEntry<D>& entry)
      : name_(std::move(name)), plan_(plan), entry_(entry), least_(plan.steps, kNever) {}

  void start() {
    broad_phase_ = make_broad_phase<D>(choose_with_parameters(name_, entry_.needs), entry_, plan_.options);
    round_.clear();
  }
  void run(const std::vector<WatchedStep<D>>& steps, std::uint32_t first) {
    std::vector<std::uint64_t> hashes;
    for (std::uint32_t k = 0; k < steps.size(); ++k) {
      keep(first + k, timed_step(steps[k].requests, *broad_phase_));
      hashes.push_back(hash_pairs(broad_phase_->pairs()));
    }
    for (std::size_t k = 0; k < steps.size(); ++k)
      if (hashes[k] != steps[k].pairs_hash)
        throw std::logic_error(name_ + " reports other pairs alone than the broad phase in " +
                               plan_.scene.name + " at step " + std::to_string(first + k + 1));
  }
  void finish() { round_medians_.push_back(median(round_)); }

  /// In nanoseconds, the least of all rounds.
  [[nodiscard]] const std::vector<double>& least() const { return least_; }
  [[nodiscard]] BenchRow row(std::uint32_t objects) const {
    BenchRow row;
    row.cell = {plan_.scene.name, D, objects, 1};
    row.algorithm = name_;
    row.steps = plan_.steps;
    row.pairs = pairs_ / (plan_.steps * round_medians_.size());
    row.round_ns = per_object(round_medians_, objects);
    set_times(row, per_object(least_, objects));
    return row;
  }

 private:
  void keep(std::uint32_t step, double spent) {
    if (step < plan_.warm_up) return;
    double& least = least_[step - plan_.warm_up];
    least = std::min(least, spent);
    round_.push_back(spent);
    pairs_ += broad_phase_->pairs().size();
  }

  std::string name_;
  const LoopPlan& plan_;
  const SceneEntry<D>& entry_;
  std::unique_ptr<BroadPhase<D>> broad_phase_;
  std::vector<double> least_;
  std::vector<double> round_;
  std::vector<double> round_medians_;
  std::uint64_t pairs_ = 0;  ///< in all rounds
};

template <int D>
class LoopRun {
 public:
  LoopRun(const LoopPlan& plan, const SceneEntry<D>& entry, const std::string& name)
      : plan_(plan), entry_(entry), choice_(choose_with_parameters(name, entry.needs)), costs_(plan.steps) {
    alone_.emplace_back(name, plan, entry);
    for (const std::string& variant : plan.variants) alone_.emplace_back(variant, plan, entry);
  }

  /// False after a request to stop.
  bool play_round(std::uint32_t round, const CellWatch& watch) {
    InLoop<D> in_loop(choice_, entry_, plan_.options);
    LoopWatch<D> watched(in_loop.broad_phase(), [&] { return in_loop.recording_seconds(); });
    const auto scene = entry_.make(watched, plan_.options);
    for (Alone<D>& alone : alone_) alone.start();
    const std::uint32_t last = plan_.warm_up + plan_.steps;
    while (scene->step() < last) {
      if (watch.stop()) return false;
      const std::uint32_t first = scene->step();
      while (scene->step() < std::min(first + kBlock, last)) {
        advance(*scene, watched);
        in_loop.forget_events();
      }
      const std::vector<WatchedStep<D>> steps = watched.take();
      for (std::size_t k = 0; k < alone_.size(); ++k)
        alone_[(k + first / kBlock + round) % alone_.size()].run(steps, first);
      keep(steps, first);
    }
    for (Alone<D>& alone : alone_) alone.finish();
    objects_ = static_cast<std::uint32_t>(scene->bodies().size());
    return true;
  }

  [[nodiscard]] LoopRow row() const {
    LoopRow row{plan_.scene.name, choice_.name, D, objects_, 0, 0, 0, 0, plan_.steps, {}};
    for (const Alone<D>& alone : alone_) row.alone.push_back(alone.row(objects_));
    std::vector<double> loop;
    std::vector<double> ratio;
    std::vector<double> share;
    for (std::size_t k = 0; k < costs_.size(); ++k) {
      loop.push_back(costs_[k].loop / objects_);
      ratio.push_back(costs_[k].loop / alone_.front().least()[k]);
      share.push_back(costs_[k].loop / costs_[k].simulation);
    }
    row.loop_ns = median(loop);
    row.alone_ns = row.alone.front().median_ns;
    row.ratio = median(ratio);
    row.share = median(share);
    return row;
  }

 private:
  [[nodiscard]] StepCost* cost_of(std::uint32_t step) {
    return step < plan_.warm_up ? nullptr : &costs_[step - plan_.warm_up];
  }

  /// `scene->step()` counts from 0 before its first.
  void advance(Scene<D>& scene, LoopWatch<D>& watched) {
    StepCost* const cost = cost_of(scene.step());
    const double watching = watched.watching_ns();
    const auto start = std::chrono::steady_clock::now();
    scene.advance();
    const double spent = nanoseconds_since(start) - (watched.watching_ns() - watching);
    if (cost != nullptr) cost->simulation = std::min(cost->simulation, spent);
  }

  void keep(const std::vector<WatchedStep<D>>& steps, std::uint32_t first) {
    for (std::uint32_t k = 0; k < steps.size(); ++k)
      if (StepCost* const cost = cost_of(first + k)) cost->loop = std::min(cost->loop, steps[k].loop_ns);
  }

  const LoopPlan& plan_;
  const SceneEntry<D>& entry_;
  BroadPhaseChoice choice_;
  std::vector<Alone<D>> alone_;  ///< the broad phase of the loop, then the variants
  std::vector<StepCost> costs_;
  std::uint32_t objects_ = 0;
};

template <int D>
std::vector<LoopRow> measure(const LoopPlan& plan, const SceneEntry<D>& entry, const CellWatch& watch) {
  std::vector<LoopRun<D>> runs;
  for (const std::string& name : plan.broad_phases) runs.emplace_back(plan, entry, name);
  // Round by round, so that all meet the machine in the same minutes.
  for (std::uint32_t round = 0; round < plan.rounds; ++round)
    for (std::size_t k = 0; k < runs.size(); ++k) {
      watch.progress(plan.scene.name + ", round " + std::to_string(round + 1) + ": " + plan.broad_phases[k]);
      if (!runs[k].play_round(round, watch)) return {};
    }
  std::vector<LoopRow> rows;
  for (const LoopRun<D>& run : runs) rows.push_back(run.row());
  return rows;
}

}  // namespace

std::vector<LoopRow> measure_loops(const LoopPlan& plan, const CellWatch& watch) {
  return std::visit([&](const auto* entry) { return measure(plan, *entry, watch); }, plan.scene.entry);
}

}  // namespace kerf
