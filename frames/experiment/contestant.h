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

  /// Hands over the requests, does a step, and tells what it took. `count`: candidates are to be told.
  ContestantStep step(const StepRequests<3>& requests, bool count);
  [[nodiscard]] const BroadPhase<3>& subject() const { return *subject_; }

 private:
  std::unique_ptr<BroadPhase<3>> subject_;
};

}  // namespace kerf
