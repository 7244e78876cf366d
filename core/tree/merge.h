#pragma once

#include "core/trace/event.h"
#include "core/tree/tree.h"

namespace kerf {

/// The merge operator (paper section 4.3): a node with few objects becomes a leaf again.
///
///         (p)
///        /   \.
///     [a b]  (q)       ->     [a b c d]       one entry an object, however many sides held it
///           /   \.
///       [b c]   [c d]
///
/// Pre: `inner` is an inner node. Post: it is a leaf with the same number and the same objects; its list is
/// ordered along its parent's normal in the next sort. Cannot be refused. Event: OperatorActed{merge}.
template <int D>
OperatorActed merge(Tree<D>& tree, NodeId inner);

}  // namespace kerf
