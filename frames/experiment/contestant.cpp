#include "frames/experiment/contestant.h"

#include <utility>

#include "core/bsp/bsp.h"
#include "frames/bench/structure.h"

namespace kerf {

Contestant::Contestant(std::unique_ptr<BroadPhase<3>> subject) : subject_(std::move(subject)) {
  measure_parts(*subject_);
}

double Contestant::count_candidates() const {
  const auto count = candidates_of(*subject_);
  return count ? static_cast<double>(*count) : -1;
}

ContestantStep Contestant::step(const StepRequests<3>& requests) {
  const SplitCost cost = costed_step(requests, *subject_);
  ContestantStep result;
  result.update = cost.overhead.value();  // all contestants measure it
  result.collision = cost.total - result.update;
  if (const auto* tree = dynamic_cast<const Bsp<3>*>(subject_.get())) {
    const Statistics statistics = tree->statistics();
    result.height = statistics.height;
    result.leaves = statistics.leaves;
    for (const std::uint64_t acted : statistics.operators) result.operators += acted;
  }
  return result;
}

}  // namespace kerf
