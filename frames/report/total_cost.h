#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/objects/broad_phase.h"
#include "frames/report/contact_probe.h"
#include "frames/report/take.h"

namespace kerf {

/// Broad phase and narrow phase together, on the motion of a take. The narrow phase tests every candidate
/// again in every step: nothing is remembered of resting pairs.
template <int D>
class TotalCost {
 public:
  /// The take must outlive this. Finds the true contacts of each step.
  TotalCost(const Take<D>& take, const Poll& poll);

  /// {"broad_ns", "narrow_ns", "total_ns" (means), "p99_ns", "max_ns" (of the total): an object and step,
  /// "candidates", "contacts", "missed" (contacts that were no candidates), "missed_share",
  /// "candidates_per_contact"}
  Json run(const std::function<std::unique_ptr<BroadPhase<D>>()>& make, std::uint32_t rounds,
           const Poll& poll);

 private:
  struct Figures;

  void place(std::size_t step);
  void play(BroadPhase<D>& broad_phase, Figures& figures, bool judge, const Poll& poll);
  void begin(BroadPhase<D>& broad_phase);
  [[nodiscard]] std::vector<Pair> test(const BroadPhase<D>& broad_phase) const;

  const Take<D>* take_;
  ContactProbe<D> probe_;
  std::vector<std::vector<Pair>> contacts_;  ///< by step, sorted
};

}  // namespace kerf
