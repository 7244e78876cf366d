#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/query/history.h"
#include "core/query/node_lives.h"
#include "core/replay/position.h"
#include "core/replay/replayer.h"

namespace kerf {

/// A side of an ancestor's partitioner.
template <int D>
struct PathSide {
  NodeId node;
  Plane<D> plane;
  bool right = false;
};

/// A node at a moment: its place, its quality, and what Algorithm 1 would do with it.
template <int D>
struct NodeExplanation {
  Position at;
  NodeId id;
  bool alive = false;
  Node<D> node;                    ///< if alive
  std::vector<PathSide<D>> path;   ///< from the root down to its parent
  std::optional<Quality> quality;  ///< of its partitioner; none for a leaf
  std::string wish;                ///< what the criteria require, with the figures
  std::vector<NodeLife> lives;     ///< that began up to then, ended if they ended by then
  std::vector<Event> history;      ///< over all its lives, likewise
};

/// At the end of a step. Throws std::runtime_error for one that the recording does not have.
template <int D>
NodeExplanation<D> explain_node(Replayer<D>& replayer, std::uint32_t step, NodeId id);
/// At any moment, whose state is given.
template <int D>
NodeExplanation<D> explain_node(RecordingReader<D>& recording, const Position& at, const BspState<D>& state,
                                NodeId id);

/// The explanation in sentences, a line each.
template <int D>
std::string to_text(const NodeExplanation<D>& explanation, const GivenNames& names);

}  // namespace kerf
