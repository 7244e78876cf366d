#include "frames/bench/loop_cell.h"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>
#include <variant>

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

/// Of one step, in nanoseconds; the least of all rounds.
struct StepCost {
  double loop = 1e300;
  double alone = 1e300;
  double simulation = 1e300;  ///< all that the scene does in the step
};

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return percentile(values, 0.5);
}

template <int D>
class LoopRun {
 public:
  LoopRun(const LoopPlan& plan, const SceneEntry<D>& entry, BroadPhaseChoice choice)
      : plan_(plan), entry_(entry), choice_(std::move(choice)), costs_(plan.steps) {}

  /// False after a request to stop.
  bool round(const CellWatch& watch) {
    InLoop<D> in_loop(choice_, entry_, plan_.options);
    LoopWatch<D> watched(in_loop.broad_phase(), [&] { return in_loop.recording_seconds(); });
    const auto scene = entry_.make(watched, plan_.options);
    const auto alone = make_broad_phase<D>(choice_, entry_, plan_.options);
    const std::uint32_t last = plan_.warm_up + plan_.steps;
    while (scene->step() < last) {
      if (watch.stop()) return false;
      const std::uint32_t first = scene->step();
      while (scene->step() < std::min(first + kBlock, last)) {
        advance(*scene, watched);
        in_loop.forget_events();
      }
      run_alone(watched.take(), first, *alone);
    }
    objects_ = static_cast<std::uint32_t>(scene->bodies().size());
    return true;
  }

  [[nodiscard]] LoopRow row() const {
    LoopRow row{plan_.scene.name, choice_.name, D, objects_, 0, 0, 0, 0, plan_.steps};
    std::vector<double> loop;
    std::vector<double> alone;
    std::vector<double> ratio;
    std::vector<double> share;
    for (const StepCost& cost : costs_) {
      loop.push_back(cost.loop / objects_);
      alone.push_back(cost.alone / objects_);
      ratio.push_back(cost.loop / cost.alone);
      share.push_back(cost.loop / cost.simulation);
    }
    row.loop_ns = median(loop);
    row.alone_ns = median(alone);
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

  void run_alone(const std::vector<WatchedStep<D>>& steps, std::uint32_t first, BroadPhase<D>& alone) {
    std::vector<std::uint64_t> hashes;
    for (std::size_t k = 0; k < steps.size(); ++k) {
      const double spent = timed_step(steps[k].requests, alone);
      hashes.push_back(hash_pairs(alone.pairs()));
      StepCost* const cost = cost_of(first + static_cast<std::uint32_t>(k));
      if (cost == nullptr) continue;
      cost->alone = std::min(cost->alone, spent);
      cost->loop = std::min(cost->loop, steps[k].loop_ns);
    }
    for (std::size_t k = 0; k < steps.size(); ++k)
      if (hashes[k] != steps[k].pairs_hash)
        throw std::logic_error(choice_.name + " reports other pairs alone than in " + plan_.scene.name +
                               " at step " + std::to_string(first + k + 1));
  }

  const LoopPlan& plan_;
  const SceneEntry<D>& entry_;
  BroadPhaseChoice choice_;
  std::vector<StepCost> costs_;
  std::uint32_t objects_ = 0;
};

template <int D>
std::vector<LoopRow> measure(const LoopPlan& plan, const SceneEntry<D>& entry, const CellWatch& watch) {
  std::vector<LoopRun<D>> runs;
  for (const std::string& name : plan.broad_phases)
    runs.emplace_back(plan, entry, choose_broad_phase(name, entry.needs));
  // Round by round, so that all meet the machine in the same minutes.
  for (std::uint32_t round = 0; round < plan.rounds; ++round)
    for (std::size_t k = 0; k < runs.size(); ++k) {
      watch.progress(plan.scene.name + ", round " + std::to_string(round + 1) + ": " + plan.broad_phases[k]);
      if (!runs[k].round(watch)) return {};
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
