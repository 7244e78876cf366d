#include "core/tree/tree_structure.h"

#include <vector>

namespace kerf {
namespace {

/// Too large a leaf has no ordered list: each of its entries is tested against each.
template <int D>
void tell_tests(const Node<D>& leaf, StructureParts<D>& parts) {
  const std::vector<Entry>& entries = leaf.entries;
  for (std::size_t i = 0; i < entries.size(); ++i)
    for (std::size_t k = i + 1; k < entries.size(); ++k) {
      if (!leaf.unsorted && entries[k].key.lo > entries[i].key.hi) break;
      parts.tell_tested(entries[i].object, entries[k].object);
    }
}

}  // namespace

template <int D>
void describe_tree(const Tree<D>& tree, bool has_lists, StructureParts<D>& parts) {
  parts.kind = "BSP tree";
  parts.holding = Holding::reaching;
  std::vector<std::uint32_t> cell_of(tree.slots(), kNoPart);
  for_each_node(tree, tree.root(), [&](NodeId id) {
    const Node<D>& node = tree[id];
    const auto cell = static_cast<std::uint32_t>(parts.cells.size());
    cell_of[id.index()] = cell;
    StructureCell<D> told{everywhere<D>(), id.value, kNoPart, node.depth, kNoPart};
    if (!node.parent.is_none()) {
      told.parent = cell_of[node.parent.index()];
      told.cut = static_cast<std::uint32_t>(parts.cuts.size());
      parts.cuts.push_back({tree[node.parent].plane, tree[node.parent].right == id});
    }
    parts.cells.push_back(told);
    for (const Entry& entry : node.entries) parts.members.push_back({cell, entry.object});
    if (has_lists && node.is_leaf()) tell_tests(node, parts);
  });
  if (has_lists) {
    parts.end_tested();
  } else {
    parts.unseen = "vectors of boxes are tested at a time: which is not known";
  }
  parts.bytes = bytes_of(tree.nodes()) + tree.entries() * sizeof(Entry);
}

template void describe_tree(const Tree<2>&, bool, StructureParts<2>&);
template void describe_tree(const Tree<3>&, bool, StructureParts<3>&);

}  // namespace kerf
