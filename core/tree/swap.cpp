#include "core/tree/swap.h"

#include <vector>

#include "core/tree/criteria.h"
#include "core/tree/placement.h"
#include "core/tree/subtree.h"

namespace kerf {
namespace {

/// The mask without the ancestor at `depth`: deeper bits move up by one.
constexpr DepthMask without_depth(DepthMask mask, std::uint32_t depth) {
  const DepthMask above = bits_above(depth);
  return (mask & above) | ((mask >> 1U) & ~above);
}

/// Moves the subtree from `top` one level up, over the place of its parent at `depth`.
template <int D>
void lift(Tree<D>& tree, NodeId top, std::uint32_t depth) {
  std::vector<NodeId> nodes;
  for_each_node(tree, top, [&](NodeId id) { nodes.push_back(id); });
  for (const NodeId id : nodes) {
    Node<D>& node = tree[id];
    --node.depth;
    node.right_of = without_depth(node.right_of, depth);
    ++node.version;
    for (Entry& entry : node.entries) entry.straddle = without_depth(entry.straddle, depth);
  }
}

/// Hangs `child` where `old_child` hung. A leaf's list belongs to its new parent's direction.
template <int D>
void replace_child(Tree<D>& tree, NodeId old_child, NodeId child) {
  const NodeId parent = tree[old_child].parent;
  tree[child].parent = parent;
  if (parent.is_none()) {
    tree.set_root(child);
  } else {
    (tree[parent].left == old_child ? tree[parent].left : tree[parent].right) = child;
  }
  if (!tree[child].is_leaf()) return;
  tree[child].direction = list_direction(tree, parent);
  renew_keys(tree, child);
}

/// The objects below `light` that the other subtree of its parent does not hold already.
template <int D>
std::vector<Stored> only_in(const Tree<D>& tree, NodeId light, std::uint32_t parent_depth) {
  std::vector<Stored> homeless;
  for (const Stored& item : collect(tree, light))
    if ((item.above & depth_bit(parent_depth)) == 0) homeless.push_back(item);
  return homeless;
}

}  // namespace

template <int D>
OperatorActed swap(Tree<D>& tree, NodeId inner) {
  const Quality before = quality(tree, inner);
  const NodeRef ref = tree.ref(inner);
  const std::uint32_t depth = tree[inner].depth;
  const std::uint32_t direction = tree[inner].direction;
  const Scalar offset = tree[inner].plane.offset;
  const NodeId heavy = heavier_child(tree, inner);
  const NodeId light = heavy == tree[inner].left ? tree[inner].right : tree[inner].left;

  const std::vector<Stored> homeless = only_in(tree, light, depth);
  release_below(tree, light);
  lift(tree, heavy, depth);
  replace_child(tree, inner, heavy);
  tree.release(inner);
  for (const Stored& item : homeless) place(tree, heavy, item.object, item.above);
  const Quality after = tree[heavy].is_leaf() ? Quality{tree[heavy].population, 0, 0} : quality(tree, heavy);
  return {Operator::swap, ref, before, after, direction, offset, 0};
}

template OperatorActed swap<2>(Tree<2>&, NodeId);
template OperatorActed swap<3>(Tree<3>&, NodeId);

}  // namespace kerf
