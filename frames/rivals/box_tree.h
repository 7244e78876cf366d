#pragma once

#include <cstdint>
#include <vector>

#include "core/objects/structure.h"

namespace kerf {

/// A node of a library's tree of boxes.
template <int D, class Node>
struct BoxTreeNode {
  Box<D> box;
  bool is_leaf = false;
  ObjectId object;  ///< of a leaf
  Node left{};      ///< of any other node
  Node right{};
  std::uint32_t name = kNoPart;  ///< none: its place in the walk
};

/// Describes a tree of boxes, left before right. `look(node)` returns its BoxTreeNode.
template <int D, class Node, class Look>
void tell_box_tree(Node root, Look look, StructureParts<D>& parts) {
  struct Visit {
    Node node;
    std::uint32_t parent;
    std::uint32_t depth;
  };
  std::vector<Visit> todo{{root, kNoPart, 0}};
  while (!todo.empty()) {
    const Visit visit = todo.back();
    todo.pop_back();
    const BoxTreeNode<D, Node> node = look(visit.node);
    const auto cell = static_cast<std::uint32_t>(parts.cells.size());
    parts.cells.push_back(
        {node.box, node.name == kNoPart ? cell : node.name, visit.parent, visit.depth, kNoPart});
    if (node.is_leaf) {
      parts.members.push_back({cell, node.object});
      continue;
    }
    todo.push_back({node.right, cell, visit.depth + 1});
    todo.push_back({node.left, cell, visit.depth + 1});
  }
}

}  // namespace kerf
