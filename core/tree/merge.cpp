#include "core/tree/merge.h"

#include <vector>

#include "core/tree/criteria.h"
#include "core/tree/placement.h"
#include "core/tree/subtree.h"

namespace kerf {

template <int D>
OperatorActed merge(Tree<D>& tree, NodeId inner) {
  const Quality before = quality(tree, inner);
  const Plane<D> plane = tree[inner].plane;
  const std::uint32_t old_direction = tree[inner].direction;
  const std::vector<Stored> stored = collect(tree, inner);
  release_below(tree, tree[inner].left);
  release_below(tree, tree[inner].right);

  Node<D>& node = tree[inner];
  node.left = NodeId::none();
  node.right = NodeId::none();
  node.plane = {};
  node.direction = list_direction(tree, node.parent);
  node.retry_step = 0;
  node.refusals = 0;
  for (const Stored& item : stored) tree.add_entry(inner, item.object, item.above);
  return {Operator::merge, tree.ref(inner), before, {before.population, 0, 0},
          old_direction,   plane.offset,    0};
}

template OperatorActed merge<2>(Tree<2>&, NodeId);
template OperatorActed merge<3>(Tree<3>&, NodeId);

}  // namespace kerf
