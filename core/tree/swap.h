#pragma once

#include "core/trace/event.h"
#include "core/tree/tree.h"

namespace kerf {

/// The child that takes the node's place.
template <int D>
NodeId heavier_child(const Tree<D>& tree, NodeId inner) {
  const Node<D>& node = tree[inner];
  return tree[node.left].population >= tree[node.right].population ? node.left : node.right;
}

/// The swap operator (paper section 4.5): a node whose partitioner cannot be repaired is deleted and replaced
/// by the root of its more populous subtree, into which the objects of the other subtree are inserted.
///
///         (p)
///        /   \.
///      [x]   (q)        ->        (q)
///           /   \.               /   \.
///        [a b]  [c d]        [a b]   [c d x]
///
/// Below q every straddle and right-of bit deeper than p's depth moves up by one, p's own bit is dropped.
/// Pre: `inner` is an inner node. Post: `inner` and its emptier subtree are dead. Cannot be refused.
/// Event: OperatorActed{swap}; `after` is the quality of q (if it is inner).
template <int D>
OperatorActed swap(Tree<D>& tree, NodeId inner);

}  // namespace kerf
