#pragma once

#include <vector>

#include "core/base/config.h"
#include "core/trace/event.h"
#include "core/tree/tree.h"

namespace kerf {

/// Keeps entries bounded when motion, not a split, makes too many (ours: the paper asks for a limit in
/// section 7). Boxes that suddenly grow or gather can straddle every partitioner; each is then in every leaf,
/// and the sweep is slower than without a tree until swaps, one at a time, have taken it down.
///
/// Post: either entries were at most twice `max_entries` times the objects and nothing happened, or they are
/// at most `max_entries` times the objects. Nodes are merged from the root down where more than
/// `repair_redundancy` of the objects lie on both sides; while that is not enough the share is halved.
/// Events: one OperatorActed{merge} for each merged node.
template <int D>
std::vector<OperatorActed> shed_entries(Tree<D>& tree, const Config& config);

}  // namespace kerf
