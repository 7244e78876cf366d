#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/base/short_stack.h"
#include "core/base/task_pool.h"
#include "core/geometry/direction_set.h"
#include "core/objects/object_table.h"
#include "core/tree/node.h"
#include "core/tree/projector.h"

namespace kerf {

/// A leaf and a number of its entries.
struct EntryCount {
  NodeId leaf;
  std::uint32_t entries = 0;
};

/// The tree as a value: nodes and boxes in arrays, links as indices. A copy is a keyframe.
///
/// Invariant (checked by `validate`): every placed object has one entry in every leaf that its box reaches by
/// `classify`, and `straddle`, `right_of`, `depth` and `population` agree with the links.
template <int D>
class Tree {
 public:
  explicit Tree(std::shared_ptr<const Projector<D>> projector);

  [[nodiscard]] NodeId root() const { return root_; }
  [[nodiscard]] const Node<D>& operator[](NodeId id) const { return nodes_[id.index()]; }
  [[nodiscard]] Node<D>& operator[](NodeId id) { return nodes_[id.index()]; }
  /// Slots of nodes, dead ones included: the size for arrays kept per node.
  [[nodiscard]] std::uint32_t slots() const { return static_cast<std::uint32_t>(nodes_.size()); }
  [[nodiscard]] NodeRef ref(NodeId id) const { return {id, nodes_[id.index()].generation}; }
  [[nodiscard]] bool is_alive(NodeRef ref) const;
  [[nodiscard]] const DirectionSet<D>& directions() const { return projector_->directions(); }
  [[nodiscard]] const std::shared_ptr<const Projector<D>>& projector() const { return projector_; }
  /// The interval of a placed object along a direction of the set.
  [[nodiscard]] Interval project(std::uint32_t direction, ObjectId object) const {
    return (*projector_)(direction, table.box(object), table.extra(object));
  }
  /// The interval of any volume of the table's kind.
  [[nodiscard]] Interval project(std::uint32_t direction, const Volume<D>& volume) const {
    return (*projector_)(direction, volume.box, volume.extra.data());
  }
  [[nodiscard]] std::uint64_t entries() const { return entries_; }
  /// Objects that have a place in the tree: those present and not quarantined.
  [[nodiscard]] std::uint32_t objects() const { return nodes_[root_.index()].population; }

  /// All slots, dead ones included, and the dead ones in the order of their reuse.
  [[nodiscard]] const std::vector<Node<D>>& nodes() const { return nodes_; }
  [[nodiscard]] const std::vector<NodeId>& unused() const { return free_; }
  /// Takes over the nodes of another tree with the same projector. Throws std::runtime_error for broken
  /// links.
  void assign(std::vector<Node<D>> nodes, std::vector<NodeId> unused, NodeId root);

  /// Volumes as they are placed. Operators classify by these and by nothing else.
  ObjectTable<D> table;

  // For operators and placement only.
  NodeId make_leaf(NodeId parent, bool right, std::uint32_t direction);
  void release(NodeId id);
  void set_root(NodeId id) { root_ = id; }
  /// Puts an entry for `object` into the leaf and counts it.
  void add_entry(NodeId leaf, ObjectId object, DepthMask straddle);
  /// Replaces all entries of the leaf without looking at them.
  void set_entries(NodeId leaf, std::vector<Entry> entries);
  void clear_entries(NodeId leaf);
  /// The leaf's entries, now `count` of them, for the caller to write. Different leaves can be refilled at
  /// the same time; `count_entries` must follow.
  std::vector<Entry>& refill(NodeId leaf, std::size_t count);
  void count_entries();
  /// Removes the entries of all marked objects from the leaves, each given once with the number of its marked
  /// entries. Keeps the order of the others.
  void drop_marked_entries(std::span<const EntryCount> marked, TaskPool& pool);
  /// Removes the entries of all marked objects from the leaf and calls `visit` with each of them before.
  /// Keeps the order of the others.
  template <class Visit>
  void drop_marked_entries(NodeId leaf, Visit visit);
  /// A mark per object; all are off between operations.
  void set_mark(ObjectId object, bool on);

 private:
  std::shared_ptr<const Projector<D>> projector_;
  std::vector<Node<D>> nodes_;
  std::vector<NodeId> free_;
  std::vector<std::uint8_t> marks_;
  NodeId root_;
  std::uint64_t entries_ = 0;
};

template <int D>
template <class Visit>
void Tree<D>::drop_marked_entries(NodeId leaf, Visit visit) {
  Node<D>& node = nodes_[leaf.index()];
  const auto goes = [&](const Entry& entry) {
    const bool is_marked = marks_[entry.object.index()] != 0;
    if (is_marked) visit(entry);
    return is_marked;
  };
  const std::size_t dropped = std::erase_if(node.entries, goes);
  if (dropped > 0) ++node.version;
  entries_ -= dropped;
}

/// Calls `visit(id)` for each node below `from`, itself included, left before right, parents first.
template <int D, class Visit>
void for_each_node(const Tree<D>& tree, NodeId from, Visit visit) {
  ShortStack<NodeId> todo(from);  // no recursion: the input decides the height
  while (!todo.empty()) {
    const NodeId id = todo.pop();
    visit(id);
    if (tree[id].is_leaf()) continue;
    todo.push(tree[id].right);
    todo.push(tree[id].left);
  }
}

/// The leaves of a tree, left before right.
template <int D>
void list_leaves(const Tree<D>& tree, std::vector<NodeId>& leaves) {
  leaves.clear();
  for_each_node(tree, tree.root(), [&](NodeId id) {
    if (tree[id].is_leaf()) leaves.push_back(id);
  });
}

}  // namespace kerf
