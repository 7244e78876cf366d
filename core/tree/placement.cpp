#include "core/tree/placement.h"

#include <array>
#include <bit>

#include "core/base/tuning.h"

namespace kerf {
namespace {

struct Visit {
  NodeId node;
  DepthMask straddle = 0;
};

/// The nodes still to visit on a walk down: at most one sibling for each level.
class WalkStack {
 public:
  explicit WalkStack(NodeId from, DepthMask straddle = 0) { push(from, straddle); }
  void push(NodeId node, DepthMask straddle = 0) {
    nodes_[size_] = node.value;
    straddles_[size_++] = straddle;
  }
  Visit pop() {
    --size_;
    return {{nodes_[size_]}, straddles_[size_]};
  }
  [[nodiscard]] bool empty() const { return size_ == 0; }

 private:
  static constexpr std::size_t kRoom = kMaxHeight + 2;
  std::size_t size_ = 0;
  std::uint32_t nodes_[kRoom];  // unused places have no value: most walks are short
  DepthMask straddles_[kRoom];
};

/// Removes the marked objects from a leaf below `from`, and subtracts them from each node up to there that
/// has no copy of them farther left.
template <int D>
void take_out_marked(Tree<D>& tree, NodeId from, NodeId leaf) {
  std::array<std::uint32_t, kMaxHeight + 1>
      going{};  // by the depth from which on the copy in this leaf is the leftmost
  std::uint32_t leftmost = 0;
  tree.drop_marked_entries(leaf, [&](const Entry& entry) {
    ++going[static_cast<std::size_t>(std::bit_width(entry.straddle & tree[leaf].right_of))];
    ++leftmost;
  });
  for (NodeId id = leaf; leftmost > 0; id = tree[id].parent) {
    tree[id].population -= leftmost;
    if (id == from) return;
    leftmost -= going[tree[id].depth];
  }
}

/// Where a box lies relative to the partitioner of an inner node, in a tree of boxes.
template <int D>
Sides sides_of(const Node<D>& node, const Box<D>& box) {
  return classify(project(node.direction, node.plane.normal, box), node.plane.offset);
}

/// Appends every node below `from` that the object reaches.
template <int D>
void reach_nodes(const Tree<D>& tree, NodeId from, ObjectId object, std::vector<NodeId>& passed) {
  WalkStack todo(from);
  while (!todo.empty()) {
    const NodeId id = todo.pop().node;
    const Node<D>& node = tree[id];
    passed.push_back(id);
    if (node.is_leaf()) continue;
    const Sides sides = classify(tree.project(node.direction, object), node.plane.offset);
    if (sides.right) todo.push(node.right);
    if (sides.left) todo.push(node.left);
  }
}

/// Whether two objects reach the same leaves, on the same sides, given the sides of each at a node. Calls
/// `visit` with the leaves; if not, with some of them.
template <int D, class First, class Second, class Visit>
bool walk_alike(const Tree<D>& tree, First first, Second second, Visit visit) {
  WalkStack todo(tree.root());
  while (!todo.empty()) {
    const NodeId id = todo.pop().node;
    const Node<D>& node = tree[id];
    if (node.is_leaf()) {
      visit(id);
      continue;
    }
    const Sides sides = first(node);
    if (sides != second(node)) return false;
    if (sides.right) todo.push(node.right);
    if (sides.left) todo.push(node.left);
  }
  return true;
}

}  // namespace

template <int D>
std::uint32_t place(Tree<D>& tree, NodeId from, ObjectId object, DepthMask above) {
  std::uint32_t leaves = 0;
  WalkStack todo(from, above);
  while (!todo.empty()) {
    const Visit visit = todo.pop();
    Node<D>& node = tree[visit.node];
    ++node.population;
    if (node.is_leaf()) {
      tree.add_entry(visit.node, object, visit.straddle);
      ++leaves;
      continue;
    }
    const Sides sides = classify(tree.project(node.direction, object), node.plane.offset);
    const DepthMask straddle = visit.straddle | (sides.straddle() ? depth_bit(node.depth) : 0);
    if (sides.right) todo.push(node.right, straddle);
    if (sides.left) todo.push(node.left, straddle);
  }
  return leaves;
}

template <int D>
void displace(Tree<D>& tree, NodeId from, std::span<const ObjectId> leaving) {
  if (leaving.size() * tuning::kObjectsPerLeaver < tree[from].population) {
    std::vector<NodeId> passed;
    for (const ObjectId object : leaving) reach_nodes(tree, from, object, passed);
    const Departure departure{leaving, passed};
    TaskPool alone;
    return displace<D>(tree, {&departure, 1}, alone);
  }
  for (const ObjectId object : leaving) tree.set_mark(object, true);
  for_each_node(tree, from, [&](NodeId id) {
    if (tree[id].is_leaf()) take_out_marked(tree, from, id);
  });
  for (const ObjectId object : leaving) tree.set_mark(object, false);
}

template <int D>
void displace(Tree<D>& tree, std::span<const Departure> departures, TaskPool& pool) {
  std::vector<EntryCount> marked;
  std::vector<std::uint32_t> nth(tree.slots());  // a leaf's place in `marked`, from 1 on
  for (const Departure& departure : departures) {
    for (const ObjectId object : departure.objects) tree.set_mark(object, true);
    for (const NodeId id : departure.passed) {
      --tree[id].population;
      if (!tree[id].is_leaf()) continue;
      if (nth[id.index()] == 0) {
        marked.push_back({id, 0});
        nth[id.index()] = static_cast<std::uint32_t>(marked.size());
      }
      ++marked[nth[id.index()] - 1].entries;
    }
  }
  tree.drop_marked_entries(marked, pool);
  for (const Departure& departure : departures)
    for (const ObjectId object : departure.objects) tree.set_mark(object, false);
}

template <int D>
bool try_keep_in_leaves(Tree<D>& tree, ObjectId object, const Volume<D>& new_volume) {
  const auto sides_of = [&tree](const auto& what) {
    return
        [&](const Node<D>& node) { return classify(tree.project(node.direction, what), node.plane.offset); };
  };
  return walk_alike(tree, sides_of(object), sides_of(new_volume),
                    [&tree](NodeId leaf) { tree[leaf].unsorted = true; });
}

template <int D>
void reach(const Tree<D>& tree, const Box<D>& box, std::vector<Reached>& reached,
           std::vector<NodeId>& passed) {
  WalkStack todo(tree.root());
  while (!todo.empty()) {
    const Visit visit = todo.pop();
    const Node<D>& node = tree[visit.node];
    passed.push_back(visit.node);
    if (node.is_leaf()) {
      reached.push_back({visit.node, visit.straddle});
      continue;
    }
    const Sides sides = sides_of(node, box);
    const DepthMask straddle = visit.straddle | (sides.straddle() ? depth_bit(node.depth) : 0);
    if (sides.right) todo.push(node.right, straddle);
    if (sides.left) todo.push(node.left, straddle);
  }
}

template <int D>
bool reach_alike(const Tree<D>& tree, const Box<D>& first, const Box<D>& second,
                 std::vector<NodeId>& leaves) {
  const auto by_node = [](const Box<D>& box) {
    return [&box](const Node<D>& node) { return sides_of(node, box); };
  };
  return walk_alike(tree, by_node(first), by_node(second), [&](NodeId leaf) { leaves.push_back(leaf); });
}

template <int D>
std::vector<Stored> collect(const Tree<D>& tree, NodeId from) {
  const DepthMask above = bits_above(tree[from].depth);
  std::vector<Stored> stored;
  stored.reserve(tree[from].population);
  for_each_node(tree, from, [&](NodeId id) {
    // The leftmost copy below `from` lies right of no plane below `from` that its object straddles.
    for (const Entry& entry : tree[id].entries)
      if ((entry.straddle & tree[id].right_of & ~above) == 0)
        stored.push_back({entry.object, entry.straddle & above});
  });
  return stored;
}

#define KERF_INSTANTIATE(D)                                                                           \
  template std::uint32_t place<D>(Tree<D>&, NodeId, ObjectId, DepthMask);                             \
  template void displace<D>(Tree<D>&, NodeId, std::span<const ObjectId>);                             \
  template void displace<D>(Tree<D>&, std::span<const Departure>, TaskPool&);                         \
  template bool try_keep_in_leaves<D>(Tree<D>&, ObjectId, const Volume<D>&);                          \
  template void reach<D>(const Tree<D>&, const Box<D>&, std::vector<Reached>&, std::vector<NodeId>&); \
  template bool reach_alike<D>(const Tree<D>&, const Box<D>&, const Box<D>&, std::vector<NodeId>&);   \
  template std::vector<Stored> collect<D>(const Tree<D>&, NodeId);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
