#include "frames/experiment/contestant.h"

#include <chrono>

#include "core/broad_phase/loose_octree.h"
#include "core/broad_phase/sweep_and_prune.h"
#include "core/bsp/bsp.h"
#include "frames/rivals/step_timer.h"
#include "sims3d/rivals/ode_space.h"

namespace kerf {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Of the last step, the part that brought the structure up to date.
double arranging_seconds(const BroadPhase<3>& subject) {
  if (const auto* tree = dynamic_cast<const Bsp<3>*>(&subject)) {
    const Statistics statistics = tree->statistics();
    double seconds = 0;
    for (const Phase phase : {Phase::place, Phase::sort, Phase::schedule, Phase::operate})
      seconds += statistics.phase_seconds[static_cast<std::size_t>(phase)];
    return seconds;
  }
  if (const auto* tabled = dynamic_cast<const Tabled<3>*>(&subject)) return tabled->arrange_seconds();
  if (const auto* space = dynamic_cast<const OdeSpace*>(&subject)) return space->arrange_seconds();
  return 0;
}

/// Pairs of entries whose intervals on their leaf's ordered list overlap, as the paper counts them.
double list_overlaps(const Tree<3>& tree) {
  double count = 0;
  for_each_node(tree, tree.root(), [&](NodeId id) {
    const std::vector<Entry>& entries = tree[id].entries;
    if (!tree[id].is_leaf()) return;
    if (tree[id].unsorted) {  // too large a leaf for an ordered list
      count += static_cast<double>(entries.size()) * static_cast<double>(entries.size() - 1) / 2;
      return;
    }
    for (std::size_t i = 0; i < entries.size(); ++i)
      for (std::size_t k = i + 1; k < entries.size() && entries[k].key.lo <= entries[i].key.hi; ++k) ++count;
  });
  return count;
}

}  // namespace

Contestant::Contestant(std::unique_ptr<BroadPhase<3>> subject) : subject_(std::move(subject)) {
  if (auto* space = dynamic_cast<OdeSpace*>(subject_.get())) space->separate_times();
}

double Contestant::count_candidates() const {
  if (const auto* octree = dynamic_cast<const LooseOctree<3>*>(subject_.get()))
    return static_cast<double>(octree->candidates());
  if (const auto* lists = dynamic_cast<const SweepAndPrune<3>*>(subject_.get()))
    return static_cast<double>(lists->candidates());
  if (const auto* space = dynamic_cast<const OdeSpace*>(subject_.get())) return space->count_candidates();
  const auto* tree = dynamic_cast<const Bsp<3>*>(subject_.get());
  return tree != nullptr && !tree->config().byte_sweep ? list_overlaps(tree->tree()) : -1;
}

ContestantStep Contestant::step(const StepRequests<3>& requests) {
  const StepTimer handing_over(true);
  apply(requests, *subject_);
  const double handed_over = handing_over.milliseconds();
  const Clock::time_point start = Clock::now();
  const StepTimer stepping(true);
  subject_->step();
  const double stepped = stepping.milliseconds();
  // The subjects measure wall time, which includes what other programs took of the processor.
  const double arranging = stepped * arranging_seconds(*subject_) / seconds_since(start);
  ContestantStep result;
  result.update = handed_over + arranging;
  result.collision = stepped - arranging;
  if (const auto* tree = dynamic_cast<const Bsp<3>*>(subject_.get())) {
    const Statistics statistics = tree->statistics();
    result.height = statistics.height;
    result.leaves = statistics.leaves;
    for (const std::uint64_t acted : statistics.operators) result.operators += acted;
  }
  return result;
}

}  // namespace kerf
