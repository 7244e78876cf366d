#pragma once

#include <memory>

#include "core/objects/broad_phase.h"
#include "core/recording/step_requests.h"
#include "frames/experiment/simulation.h"

namespace kerf {

/// A broad phase in the experiment.
class Contestant {
 public:
  explicit Contestant(std::unique_ptr<BroadPhase<3>> subject) : subject_(std::move(subject)) {}

  /// Passes on the requests, does a step, and returns its cost. `count`: also count the candidates.
  ContestantStep step(const StepRequests<3>& requests, bool count);
  [[nodiscard]] const BroadPhase<3>& subject() const { return *subject_; }

 private:
  std::unique_ptr<BroadPhase<3>> subject_;
};

}  // namespace kerf
