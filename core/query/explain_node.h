#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/query/history.h"
#include "core/query/node_lives.h"
#include "core/replay/replayer.h"

namespace kerf {

/// A side of an ancestor's partitioner.
template <int D>
struct PathSide {
  NodeId node;
  Plane<D> plane;
  bool right = false;
};

/// A node at the end of a step: its place, its quality, and what Algorithm 1 would do with it.
template <int D>
struct NodeExplanation {
  std::uint32_t step = 0;
  NodeId id;
  bool alive = false;
  Node<D> node;                    ///< if alive
  std::vector<PathSide<D>> path;   ///< from the root down to its parent
  std::optional<Quality> quality;  ///< of its partitioner; none for a leaf
  std::string wish;                ///< what the criteria require, with the figures
  std::vector<NodeLife> lives;     ///< that began up to this step, ended if they ended by then
  std::vector<Event> history;      ///< over all its lives, likewise
};

/// Throws std::runtime_error for a step that the recording does not have.
template <int D>
NodeExplanation<D> explain_node(Replayer<D>& replayer, std::uint32_t step, NodeId id);

/// The explanation in sentences, a line each.
template <int D>
std::string to_text(const NodeExplanation<D>& explanation, const GivenNames& names);

}  // namespace kerf
