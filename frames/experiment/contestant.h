#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/broad_phase/broad_phase.h"
#include "frames/experiment/simulation.h"

namespace kerf {

/// What the world has said of its objects since the step before.
struct StepRequests {
  struct Newcomer {
    ObjectId object;
    Box<3> box;
    Mobility mobility;
  };
  std::vector<Newcomer> inserted;
  std::vector<ObjectId> moved;
  std::vector<Box<3>> boxes;  ///< of moved

  void clear() {
    inserted.clear();
    moved.clear();
    boxes.clear();
  }
};

/// A broad phase in the experiment.
class Contestant {
 public:
  explicit Contestant(std::unique_ptr<BroadPhase<3>> subject) : subject_(std::move(subject)) {}

  /// Hands over the requests, does a step, and tells what it took. `count`: candidates are to be told.
  ContestantStep step(const StepRequests& requests, bool count);
  [[nodiscard]] const BroadPhase<3>& subject() const { return *subject_; }

 private:
  std::unique_ptr<BroadPhase<3>> subject_;
};

}  // namespace kerf
