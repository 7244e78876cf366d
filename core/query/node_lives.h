#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/recording/operator_rows.h"

namespace kerf {

/// Steps from one event to another; without an end: to the end of the run.
struct LifeSpan {
  std::uint32_t first_step = 0;  ///< 0: from the beginning
  std::uint64_t first_event = 0;
  std::optional<std::uint32_t> last_step;
  std::uint64_t last_event = 0;  ///< only if it has ended
};

/// A life of a node's slot: a split of its parent begins it, a merge or a swap above ends it.
struct NodeLife {
  std::uint32_t generation = 0;
  LifeSpan span;
  std::vector<LifeSpan> divided;  ///< when it had children
};

/// The lives of all nodes of a run, by slot. The root's first one begins with the run; a node that was born
/// and died in the same step has its life, too. Throws std::runtime_error for operators that cannot have
/// followed one another.
std::vector<std::vector<NodeLife>> find_node_lives(std::span<const OperatorRow> operators);

}  // namespace kerf
