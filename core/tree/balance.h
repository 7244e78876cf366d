#pragma once

#include <optional>

#include "core/base/config.h"
#include "core/trace/event.h"
#include "core/tree/partitioner.h"
#include "core/tree/tree.h"

namespace kerf {

/// The balance operator (paper section 4.4): the partitioner of an unbalanced node is shifted along its
/// normal. Only objects with an end in the interval between the old and the new offset are touched; they are
/// taken out and placed again, which also renews their straddle bits.
///
///         (p: d)                     (p: d')
///        /      \.                  /       \.
///     [a]   [b c d e f]   ->    [a b c]   [d e f]
///
/// Pre: `inner` is an inner node. Post: its partitioner is good, or, if no shift makes it good, nothing
/// changed. Event: OperatorActed{balance}.
template <int D>
std::optional<OperatorActed> balance(Tree<D>& tree, NodeId inner, const Config& config, Refusal& refusal);

}  // namespace kerf
