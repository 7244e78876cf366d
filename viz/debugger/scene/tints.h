#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/recording/operator_rows.h"
#include "core/replay/position.h"
#include "core/tree/tree_snapshot.h"
#include "viz/debugger/model/view_settings.h"
#include "viz/draw/color.h"

namespace kerf {

/// The last step up to a moment in which an operator acted on each of so many slots of nodes; 0: none has.
std::vector<std::uint32_t> last_changes(std::span<const OperatorRow> operators, const Position& moment,
                                        std::size_t slots);

/// A tree at a moment: all that colours are taken from.
struct TreeMoment {
  const TreeSnapshot& tree;
  std::uint32_t step = 0;
  std::span<const std::uint32_t> last_changes;  ///< by slot; read for the age alone
};

/// The population, balance and so on of a node in figures, for tables and colours.
struct NodeFigures {
  double population = 0;
  double balance = 1;  ///< of the partitioner; of a leaf: of the one above it, as the next
  double redundancy = 0;
  double cost = 0;  ///< pairs that a sweep of the leaf may look at; of a partitioner: of all leaves below it
  double age = 0;   ///< steps since an operator acted on it; on a leaf: on the partitioner above
};
/// By slot; those of dead nodes mean nothing.
std::vector<NodeFigures> find_figures(const TreeMoment& moment);

/// A value for each living node by the meaning of the tint, and the value at which the colours should end.
/// Where the tint is of leaves alone (population, cost), a partitioner has the greatest value below it.
struct NodeTints {
  std::vector<float> values;
  double end = 1;
  /// From 0 to 1, for colours that end there.
  [[nodiscard]] float share(NodeId node, double colors_end) const;
  [[nodiscard]] Color color(NodeId node, double colors_end) const;
};
NodeTints find_tints(const TreeMoment& moment, Tint tint);

}  // namespace kerf
