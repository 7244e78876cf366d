#pragma once

#include <optional>

#include "core/base/config.h"
#include "core/trace/decision.h"
#include "core/trace/event.h"
#include "core/tree/partitioner.h"
#include "core/tree/tree.h"

namespace kerf {

/// The split operator (paper section 4.1): a crowded leaf becomes a node with a new partitioner and two
/// leaves.
///
///        |                 |
///     [a b c d]   ->      (p)
///                        /   \.
///                    [a b]   [b c d]      b straddles p and has an entry in both
///
/// Pre: `leaf` is a leaf. Post: it is an inner node, or, if no candidate is good or a cap forbids it, nothing
/// changed. Event: OperatorActed{split}. `refusal` says why nothing happened.
template <int D>
std::optional<OperatorActed> split(Tree<D>& tree, NodeId leaf, const Config& config, Refusal& refusal);

/// As above, unless a decision replaces the choice: then the leaf is not split, or is divided by the
/// decision's partitioner if the caps allow it and both children are smaller, however good it is.
template <int D>
std::optional<OperatorActed> split(Tree<D>& tree, NodeId leaf, const Config& config, const Decision* decision,
                                   Refusal& refusal);

/// Divides a leaf by a given partitioner: the part that split and shift-split share. Returns the new quality.
template <int D>
Quality divide(Tree<D>& tree, NodeId leaf, std::uint32_t direction, Scalar offset);

/// Whether the caps on height and entries allow a leaf to be divided with that many straddlers.
template <int D>
std::optional<Refusal> forbids_division(const Tree<D>& tree, NodeId leaf, std::uint32_t straddlers,
                                        const Config& config);

}  // namespace kerf
