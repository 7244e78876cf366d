#pragma once

#include <memory>

#include "core/objects/broad_phase.h"
#include "core/recording/step_requests.h"
#include "frames/study/study.h"

namespace kerf {

/// What a broad phase is asked in the steps of a cell's motion or scene, computed beside it, so that every
/// broad phase is asked the same.
template <int D>
class Feed {
 public:
  Feed() = default;
  Feed(const Feed&) = delete;
  Feed& operator=(const Feed&) = delete;
  virtual ~Feed() = default;

  /// The objects that are there before the first step.
  [[nodiscard]] virtual StepRequests<D> begin() { return {}; }
  /// The requests of the next step.
  virtual StepRequests<D> next() = 0;
  /// An empty broad phase for them, without knowledge of what they will be but where that is needed.
  [[nodiscard]] virtual std::unique_ptr<BroadPhase<D>> make_subject(const std::string& name) const = 0;
};

template <int D>
std::unique_ptr<Feed<D>> make_feed(const RunCell& cell);

}  // namespace kerf
