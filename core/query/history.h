#pragma once

#include <vector>

#include "core/recording/recording_reader.h"

namespace kerf {

/// Two objects became a pair, or ceased to be one, in a step.
struct PairChange {
  std::uint32_t step = 0;
  bool is_pair = false;
};

/// When two objects became and ceased to be a pair up to a step, by the definition: from their boxes, without
/// the tree, and in the precision in which they were given.
template <int D>
std::vector<PairChange> pair_history(RecordingReader<D>& recording, const Pair& pair, std::uint32_t up_to);

/// All operators that were scheduled, refused or acted at a node up to a step, over all its lives.
template <int D>
std::vector<Event> node_history(RecordingReader<D>& recording, NodeId node, std::uint32_t up_to);

}  // namespace kerf
