#pragma once

#include <cstdint>
#include <optional>

#include "core/objects/broad_phase.h"
#include "core/recording/step_requests.h"
#include "core/tree/tree.h"

namespace kerf {

/// What a broad phase's structure looks like after a step.
struct Structure {
  std::optional<std::uint64_t> candidates;  ///< pairs that it left to be tested; none: unknown
  std::uint32_t leaves = 0;                 ///< of a tree of ours, as all that follows; 0 without a tree
  std::uint32_t height = 0;
  std::uint64_t entries = 0;
  std::uint64_t operators = 0;  ///< acted since the beginning
};
template <int D>
Structure structure_of(const BroadPhase<D>& subject);
/// `Structure::candidates` alone.
template <int D>
std::optional<std::uint64_t> candidates_of(const BroadPhase<D>& subject);

/// Pairs of boxes that the last step compared, by `candidates_of` or, of few objects, by the structure's
/// description of itself; none: unknown.
template <int D>
std::optional<std::uint64_t> tests_of(const BroadPhase<D>& subject, std::uint32_t objects);

/// Pairs of a tree that were left to be tested in a step with the paper's ordered lists.
template <int D>
std::uint64_t list_candidates(const Tree<D>& tree);

/// What a step cost, in milliseconds.
struct SplitCost {
  double total = 0;
  std::optional<double> overhead;  ///< taking over the boxes and bringing the structure up to date; none: the
                                   ///< broad phase does not measure this. The rest is the search for pairs
};
/// Has the broad phase measure its parts apart, which none does unless asked: a clock takes time itself.
template <int D>
void measure_parts(BroadPhase<D>& subject);
/// Passes on the requests and does a step in this thread.
template <int D>
SplitCost costed_step(const StepRequests<D>& requests, BroadPhase<D>& subject);

}  // namespace kerf
