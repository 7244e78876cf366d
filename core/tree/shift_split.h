#pragma once

#include <optional>

#include "core/base/config.h"
#include "core/trace/event.h"
#include "core/tree/partitioner.h"
#include "core/tree/tree.h"

namespace kerf {

/// The shift-split operator (paper section 4.2): a split whose partitioner is parallel to the parent's. The
/// leaf's list is already ordered along that normal, so nothing is projected and both new lists are born
/// ordered.
///
///       (p)                      (p)
///      /   \.                   /   \.
///    [..]  [a b c d]   ->    [..]   (p')        p' is p shifted to another offset
///                                  /    \.
///                               [a b]  [c d]
///
/// Pre: `leaf` is a leaf. Post: it is an inner node, or, if it has no parent, no shift of the parent's
/// partitioner is good, or a cap forbids it, nothing changed. Event: OperatorActed{shift_split}.
template <int D>
std::optional<OperatorActed> shift_split(Tree<D>& tree, NodeId leaf, const Config& config, Refusal& refusal);

/// The point where shift_split would divide, or none. Algorithm 1 asks for it before it chooses split
/// instead.
template <int D>
std::optional<ReferencePoint> shifted_partitioner(const Tree<D>& tree, NodeId leaf, const Config& config);

}  // namespace kerf
