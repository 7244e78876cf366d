#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/replay/replayer.h"
#include "core/tree/ballot.h"

namespace kerf {

/// Why an event happened.
template <int D>
struct EventExplanation {
  Event event;
  std::string reason;               ///< for an operator: the criteria of its node right before
  std::optional<Event> scheduled;   ///< for an operator: when it was listed
  std::vector<BallotEntry> ballot;  ///< for an operator that chose a partitioner
  std::vector<Vector<D>> normals;   ///< of the candidates
  std::vector<NodeId> leaves;       ///< for a placed object: its leaves now
};

/// Throws std::runtime_error for an event that the recording does not have.
template <int D>
EventExplanation<D> explain_event(Replayer<D>& replayer, std::uint64_t id);

/// The explanation in sentences, a line each.
template <int D>
std::string to_text(const EventExplanation<D>& explanation, const GivenNames& names);

}  // namespace kerf
