#pragma once

#include <memory>

#include "core/objects/broad_phase.h"
#include "core/recording/step_requests.h"
#include "frames/experiment/simulation.h"

namespace kerf {

/// A broad phase in the experiment.
class Contestant {
 public:
  explicit Contestant(std::unique_ptr<BroadPhase<3>> subject);

  /// Passes on the requests, does a step, and returns its cost, without candidates.
  ContestantStep step(const StepRequests<3>& requests);
  /// How many pairs of boxes its structure left to be compared in the last step; negative: unknown.
  [[nodiscard]] double count_candidates() const;
  [[nodiscard]] const BroadPhase<3>& subject() const { return *subject_; }

 private:
  std::unique_ptr<BroadPhase<3>> subject_;
};

}  // namespace kerf
