#include "core/tree/tree.h"

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <utility>

#include "core/base/list_room.h"

namespace kerf {

template <int D>
Tree<D>::Tree(std::shared_ptr<const Projector<D>> projector)
    : table(projector->kind()), projector_(std::move(projector)) {
  root_ = make_leaf(NodeId::none(), false, 0);
}

template <int D>
bool Tree<D>::is_alive(NodeRef ref) const {
  return ref.node.index() < nodes_.size() && nodes_[ref.node.index()].alive &&
         nodes_[ref.node.index()].generation == ref.generation;
}

template <int D>
NodeId Tree<D>::make_leaf(NodeId parent, bool right, std::uint32_t direction) {
  NodeId id{static_cast<std::uint32_t>(nodes_.size())};
  if (free_.empty()) {
    nodes_.emplace_back();
  } else {
    id = free_.back();
    free_.pop_back();
  }
  Node<D>& node = nodes_[id.index()];
  node.alive = true;
  node.parent = parent;
  node.direction = direction;
  if (parent.is_none()) return id;
  const Node<D>& above = nodes_[parent.index()];
  node.depth = above.depth + 1;
  node.right_of = above.right_of | (right ? depth_bit(above.depth) : 0);
  return id;
}

template <int D>
void Tree<D>::release(NodeId id) {
  clear_entries(id);
  Node<D> fresh;
  fresh.generation = nodes_[id.index()].generation + 1;
  nodes_[id.index()] = std::move(fresh);
  free_.push_back(id);
}

template <int D>
void Tree<D>::add_entry(NodeId leaf, ObjectId object, DepthMask straddle) {
  Node<D>& node = nodes_[leaf.index()];
  grow_list(node.entries, node.entries.size() + 1);
  node.entries.push_back({project(node.direction, object), object, straddle});
  node.unsorted = true;
  ++node.version;
  ++entries_;
}

template <int D>
void Tree<D>::set_entries(NodeId leaf, std::vector<Entry> entries) {
  entries_ += entries.size();
  entries_ -= nodes_[leaf.index()].entries.size();
  nodes_[leaf.index()].entries = std::move(entries);
  ++nodes_[leaf.index()].version;
}

template <int D>
void Tree<D>::clear_entries(NodeId leaf) {
  entries_ -= nodes_[leaf.index()].entries.size();
  nodes_[leaf.index()].entries.clear();
  ++nodes_[leaf.index()].version;
}

template <int D>
std::vector<Entry>& Tree<D>::refill(NodeId leaf, std::size_t count) {
  Node<D>& node = nodes_[leaf.index()];
  make_list_room(node.entries, count);
  node.entries.resize(count);
  node.unsorted = true;
  ++node.version;
  return node.entries;
}

template <int D>
void Tree<D>::count_entries() {
  entries_ = 0;
  for_each_node(*this, root_, [this](NodeId id) { entries_ += nodes_[id.index()].entries.size(); });
}

/// From the back, where the newest entries lie: objects that leave are often among them, and the entries
/// before are not even read.
template <int D>
void Tree<D>::drop_marked_entries(std::span<const EntryCount> marked, TaskPool& pool) {
  const auto is_marked = [this](const Entry& entry) { return marks_[entry.object.index()] != 0; };
  std::atomic<std::uint64_t> dropped = 0;
  pool.for_each(marked.size(), [&](std::size_t k, std::size_t) {
    Node<D>& leaf = nodes_[marked[k].leaf.index()];
    ++leaf.version;
    std::size_t first = leaf.entries.size();
    for (std::uint32_t left = marked[k].entries; left > 0 && first > 0;)
      left -= is_marked(leaf.entries[--first]) ? 1U : 0U;
    const auto from = leaf.entries.begin() + static_cast<std::ptrdiff_t>(first);
    const auto kept_end = std::remove_if(from, leaf.entries.end(), is_marked);
    dropped += static_cast<std::uint64_t>(leaf.entries.end() - kept_end);
    leaf.entries.erase(kept_end, leaf.entries.end());
  });
  entries_ -= dropped;
}

template <int D>
void Tree<D>::assign(std::vector<Node<D>> nodes, std::vector<NodeId> unused, NodeId root) {
  const auto leads_somewhere = [&](NodeId id) { return id.index() < nodes.size(); };
  bool sound = leads_somewhere(root);
  for (const NodeId id : unused) sound = sound && leads_somewhere(id);
  std::uint64_t entries = 0;
  for (const Node<D>& node : nodes) {
    entries += node.entries.size();
    sound = sound && node.direction < directions().size() && node.left.is_none() == node.right.is_none() &&
            (node.is_leaf() || (leads_somewhere(node.left) && leads_somewhere(node.right)));
  }
  if (!sound) throw std::runtime_error("a tree cannot be taken over: a link leads nowhere");
  nodes_ = std::move(nodes);
  free_ = std::move(unused);
  root_ = root;
  entries_ = entries;
}

template <int D>
void Tree<D>::set_mark(ObjectId object, bool on) {
  if (marks_.size() < table.bound()) marks_.resize(table.bound(), 0);
  marks_[object.index()] = on ? 1 : 0;
}

template class Tree<2>;
template class Tree<3>;

}  // namespace kerf
