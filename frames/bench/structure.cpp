#include "frames/bench/structure.h"

#include <chrono>

#include "core/broad_phase/describe.h"
#include "core/broad_phase/loose_octree.h"
#include "core/broad_phase/sweep_and_prune.h"
#include "core/bsp/bsp.h"
#include "core/related/cut_tree_policy.h"
#include "core/related/multi_level_hash.h"
#include "core/related/plane_tree.h"
#include "core/related/sphere_tree.h"
#include "frames/rivals/step_timer.h"
#include "sims3d/rivals/ode_space.h"

namespace kerf {
namespace {

/// Seconds of the last step that brought the structure up to date; none if it does not measure them.
template <int D>
std::optional<double> arranging_seconds(const BroadPhase<D>& subject) {
  if (const auto* tree = dynamic_cast<const Bsp<D>*>(&subject)) {
    const Statistics statistics = tree->statistics();
    double seconds = 0;
    for (const Phase phase : {Phase::place, Phase::sort, Phase::schedule, Phase::operate})
      seconds += statistics.phase_seconds[static_cast<std::size_t>(phase)];
    return seconds;
  }
  if (const auto* tabled = dynamic_cast<const Tabled<D>*>(&subject)) return tabled->arrange_seconds();
  if constexpr (D == 3)
    if (const auto* space = dynamic_cast<const OdeSpace*>(&subject)) return space->arrange_seconds();
  return std::nullopt;
}

/// Pairs of entries whose intervals on their leaf's ordered list overlap, as the paper counts them.
std::uint64_t overlaps_on(const std::vector<Entry>& entries) {
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < entries.size(); ++i)
    for (std::size_t k = i + 1; k < entries.size() && entries[k].key.lo <= entries[i].key.hi; ++k) ++count;
  return count;
}

}  // namespace

template <int D>
std::uint64_t list_candidates(const Tree<D>& tree) {
  std::uint64_t count = 0;
  for_each_node(tree, tree.root(), [&](NodeId id) {
    if (!tree[id].is_leaf()) return;
    const std::uint64_t size = tree[id].entries.size();
    // Too large a leaf has no ordered list.
    count += tree[id].unsorted ? size * (size - 1) / 2 : overlaps_on(tree[id].entries);
  });
  return count;
}

template <int D>
std::optional<std::uint64_t> candidates_of(const BroadPhase<D>& subject) {
  if (const auto* octree = dynamic_cast<const LooseOctree<D>*>(&subject)) return octree->candidates();
  if (const auto* lists = dynamic_cast<const SweepAndPrune<D>*>(&subject)) return lists->candidates();
  if (const auto* cuts = dynamic_cast<const CutTreePolicy<D>*>(&subject)) return cuts->candidates();
  if (const auto* planes = dynamic_cast<const PlaneTree<D>*>(&subject)) return planes->candidates();
  if (const auto* hash = dynamic_cast<const MultiLevelHash<D>*>(&subject)) return hash->candidates();
  if (const auto* spheres = dynamic_cast<const SphereTree<D>*>(&subject)) return spheres->candidates();
  if constexpr (D == 3)
    if (const auto* space = dynamic_cast<const OdeSpace*>(&subject))
      if (const double count = space->count_candidates(); count >= 0)
        return static_cast<std::uint64_t>(count);
  const auto* tree = dynamic_cast<const Bsp<D>*>(&subject);
  // Only the paper's way of a step keeps ordered lists.
  if (tree == nullptr || tree->config().byte_sweep) return std::nullopt;
  return list_candidates(tree->tree());
}

template <int D>
std::optional<std::uint64_t> tests_of(const BroadPhase<D>& subject, std::uint32_t objects) {
  constexpr std::uint32_t kMostDescribed = 10000;  // a description may list each of n * n / 2 tests
  const std::optional<std::uint64_t> candidates = candidates_of(subject);
  if (candidates || objects > kMostDescribed) return candidates;
  return describe(subject).tests;
}

template <int D>
Structure structure_of(const BroadPhase<D>& subject) {
  Structure structure;
  structure.candidates = candidates_of(subject);
  const auto* tree = dynamic_cast<const Bsp<D>*>(&subject);
  if (tree == nullptr) return structure;
  const Statistics statistics = tree->statistics();
  structure.leaves = statistics.leaves;
  structure.height = statistics.height;
  structure.entries = statistics.entries;
  for (const std::uint64_t acted : statistics.operators) structure.operators += acted;
  return structure;
}

template <int D>
void measure_parts(BroadPhase<D>& subject) {
  if (auto* tree = dynamic_cast<Bsp<D>*>(&subject)) tree->time_phases(true);
  if (auto* tabled = dynamic_cast<Tabled<D>*>(&subject)) tabled->time_arranging();
  if constexpr (D == 3)
    if (auto* space = dynamic_cast<OdeSpace*>(&subject)) space->separate_times();
}

template <int D>
SplitCost costed_step(const StepRequests<D>& requests, BroadPhase<D>& subject) {
  const StepTimer handing_over(true);
  apply(requests, subject);
  const double handed_over = handing_over.milliseconds();
  const auto start = std::chrono::steady_clock::now();
  const StepTimer stepping(true);
  subject.step();
  const double stepped = stepping.milliseconds();
  const std::chrono::duration<double> on_the_wall = std::chrono::steady_clock::now() - start;
  SplitCost cost{handed_over + stepped, std::nullopt};
  // The subjects look at the clock on the wall, which also counts what other programs took of the processor.
  if (const auto arranging = arranging_seconds(subject))
    cost.overhead = handed_over + stepped * *arranging / on_the_wall.count();
  return cost;
}

template std::uint64_t list_candidates(const Tree<2>&);
template std::uint64_t list_candidates(const Tree<3>&);
template Structure structure_of(const BroadPhase<2>&);
template Structure structure_of(const BroadPhase<3>&);
template std::optional<std::uint64_t> candidates_of(const BroadPhase<2>&);
template std::optional<std::uint64_t> candidates_of(const BroadPhase<3>&);
template std::optional<std::uint64_t> tests_of(const BroadPhase<2>&, std::uint32_t);
template std::optional<std::uint64_t> tests_of(const BroadPhase<3>&, std::uint32_t);
template void measure_parts(BroadPhase<2>&);
template void measure_parts(BroadPhase<3>&);
template SplitCost costed_step(const StepRequests<2>&, BroadPhase<2>&);
template SplitCost costed_step(const StepRequests<3>&, BroadPhase<3>&);

}  // namespace kerf
