#include "frames/experiment/experiment_maker.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <map>
#include <stdexcept>
#include <utility>

#include "frames/support/child_process.h"
#include "frames/support/errors.h"
#include "frames/support/shared_memory.h"

namespace kerf {
namespace {

/// The step that a child is at, for its parent.
class SharedStep {
 public:
  SharedStep() : step_(new (memory_.data()) std::atomic<std::uint32_t>(1)) {}
  void set(std::uint32_t step) const { step_->store(step, std::memory_order_relaxed); }
  [[nodiscard]] std::uint32_t get() const { return step_->load(std::memory_order_relaxed); }

 private:
  static_assert(std::atomic<std::uint32_t>::is_always_lock_free);
  SharedMemory memory_{sizeof(std::atomic<std::uint32_t>)};
  std::atomic<std::uint32_t>* step_;
};

std::vector<RunId> runs_of(const ExperimentPlan& plan) {
  std::vector<RunId> runs;
  for (std::uint32_t repeat = 1; repeat <= plan.repeats; ++repeat)
    for (std::uint32_t k = 0; k < plan.seeds; ++k)
      for (std::size_t simulation = 0; simulation < simulations().size(); ++simulation)
        runs.push_back({plan.kind, simulation, plan.with_seed(k), repeat});
  return runs;
}

/// What is the same in each repeat of a seed: objects, pairs and contacts.
using StepCounts = std::array<std::uint64_t, 3>;
std::vector<StepCounts> counts_of(const ExperimentRun& steps) {
  std::vector<StepCounts> counts;
  for (const ExperimentStep& row : steps) counts.push_back({row.moving, row.pairs, row.contacts});
  return counts;
}

}  // namespace

ExperimentMaker::ExperimentMaker(std::filesystem::path folder, const ExperimentPlan& plan, const Shard& shard,
                                 Replace replace)
    : folder_(std::move(folder)),
      steps_(plan.size.steps),
      forgets_(replace == Replace::earlier),
      runs_(runs_of(plan)) {
  if (!forgets_) refuse_earlier_files(folder_);
  for (std::size_t k = 0; k < runs_.size(); ++k) {
    // Simulations take differently long: each shard gets some of each, and as many runs as the others or one
    // more.
    const std::size_t turn =
        runs_[k].simulation * (runs_.size() / simulations().size()) + k / simulations().size();
    if (load_run(folder_, runs_[k], forgets_))
      ++kept_;
    else if (shard.has(turn))
      missing_.push_back(runs_[k]);
  }
  make_writable_folder(folder_);
}

void ExperimentMaker::make(const std::function<bool()>& stop) {
  for (const RunId& run : missing_) {
    make_one(run, stop);
    ++made_;
  }
}

void ExperimentMaker::make_one(const RunId& run, const std::function<bool()>& stop) {
  const SharedStep at;
  ChildProcess child([&](char) {
    const auto watch = [&](std::uint32_t step) {
      at.set(step);
      return true;
    };
    const ExperimentRun steps =
        run_simulation(simulations()[run.simulation], run.size, lineup_of(run), watch);
    at.set(run.size.steps + 1);  // from now on it is not stopped, since it is about to be saved
    save_run(folder_, run, steps);
  });
  const bool done = child.ask(' ', std::chrono::duration<double>::max(), [&] {
    const std::uint32_t step = at.get();
    show(run, std::min(step, run.size.steps));
    return step <= run.size.steps && stop();
  });
  if (done) return;
  if (stop()) throw Interrupted(interruption());
  throw std::runtime_error(name_of(run) + ": " + child.trouble() +
                           "; the runs before it are kept, and the same command goes on from there");
}

void ExperimentMaker::for_each(const std::function<void(const RunId&, ExperimentRun)>& visit) const {
  std::map<std::pair<std::size_t, std::uint64_t>, std::vector<StepCounts>> known;  // by simulation and seed
  for (const RunId& run : runs_) {
    auto steps = load_run(folder_, run, forgets_);
    if (!steps)
      throw std::runtime_error(run_path(folder_, run).string() + " is gone; the same command makes it");
    const std::vector<StepCounts> counts = counts_of(*steps);
    if (known.try_emplace({run.simulation, run.size.seed}, counts).first->second != counts)
      throw std::runtime_error(run_path(folder_, run).string() +
                               " has other pairs than the first repeat of its seed: another kerf has made "
                               "one of them; remove both, and the same command makes them");
    visit(run, std::move(*steps));
  }
}

void ExperimentMaker::show(const RunId& run, std::uint32_t step) const {
  const double all = static_cast<double>(missing_.size()) * steps_;
  const double done = static_cast<double>(made_) * steps_ + step - 1;
  const std::string left = stint_.left(done, all);
  line_.show("run " + std::to_string(made_ + 1) + " of " + std::to_string(missing_.size()) + ": " +
             name_of(run) + "  step " + std::to_string(step) + "/" + std::to_string(steps_) +
             (left.empty() ? "" : "  about ") + left);
}

std::string ExperimentMaker::interruption() const {
  return "interrupted: " + std::to_string(kept_ + made_) + " of " + std::to_string(runs_.size()) +
         " runs are in " + folder_.string() + "; the same command goes on from there";
}

}  // namespace kerf
