#pragma once

#include <string>
#include <vector>

#include "core/trace/reporter.h"
#include "core/tree/scheduler.h"
#include "tests/support/boxes.h"
#include "tests/support/planted_tree.h"

namespace kerf::test {

/// What a cell of the row holds, and so what Algorithm 1 should want there (with `kSceneConfig`).
enum class Cell {
  calm,       ///< four objects: nothing
  shifting,   ///< seven side by side along axis 0, like the plane beside them: shift-split
  crowded,    ///< seven on top of each other along axis 0, side by side along axis 1: split
  stuck,      ///< a plane beside seven objects that coincide: swap
  shiftable,  ///< a plane beside seven objects that another offset would divide: balance
  thin,       ///< a plane between two objects: merge
  lump        ///< seven objects that coincide: split, always refused
};

/// Leaves of more than 6 objects are split, nodes of fewer than 3 merged.
inline constexpr const char* kSceneConfig =
    "min_threshold=6,max_threshold=6,min_balance=0.2,free_directions=0,repair_redundancy=1";

template <int D>
struct SchedulerScene {
  kerf::Tree<D> tree;
  std::vector<NodeId> node;  ///< of each cell: its leaf, or the node of the plane within it
};

/// A tree whose leaves, from left to right along axis 0, are the cells; more planes lie between them.
template <int D>
SchedulerScene<D> scene_of(const std::vector<Cell>& cells);

/// One line for each event since the last call: like "split n5 scheduled".
std::vector<std::string> reported(Reporter<EventLog>& reporter);

/// "split n5 scheduled".
std::string scheduled(Operator op, NodeId node);

/// "split n5 refused: " and the reason.
std::string refused(Operator op, NodeId node, Refusal reason);

/// "split n5: 7 -> 7 (3 | 4)" for a leaf, "balance n5: 7 (7 | 0) -> 7 (3 | 4)" for an inner node.
std::string acted(Operator op, NodeId node, const std::string& before, const std::string& after);

}  // namespace kerf::test
