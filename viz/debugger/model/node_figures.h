#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/recording/operator_rows.h"
#include "core/replay/position.h"
#include "core/tree/tree_snapshot.h"

namespace kerf {

/// The last step up to a moment in which an operator acted on each of so many slots of nodes; 0: none has.
std::vector<std::uint32_t> last_changes(std::span<const OperatorRow> operators, const Position& moment,
                                        std::size_t slots);

/// A tree at a moment: all that figures and colours are taken from.
struct TreeMoment {
  const TreeSnapshot& tree;
  std::uint32_t step = 0;
  std::span<const std::uint32_t> last_changes;  ///< by slot; read for the age alone
};

/// A node in figures, for tables and colours.
struct NodeFigures {
  double population = 0;
  double balance = 1;  ///< of the partitioner; of a leaf: of the one above it, as the next
  double redundancy = 0;
  double cost = 0;  ///< pairs that a sweep of the leaf may look at; 0 for a partitioner
  double age = 0;   ///< steps since an operator acted on it; on a leaf: on the partitioner above
};
NodeFigures figures_of(const TreeMoment& moment, NodeId id);
/// By slot, the cost of a partitioner being that of all leaves below it; those of dead nodes mean nothing.
std::vector<NodeFigures> find_figures(const TreeMoment& moment);

/// The living nodes, children before their parents.
std::vector<NodeId> children_first(const TreeSnapshot& tree);

}  // namespace kerf
