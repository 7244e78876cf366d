#include "core/tree/validate.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/float_mode.h"

namespace kerf {
namespace {

/// Where an object must be stored, by the definition and independent of what the operators maintain.
struct Place {
  NodeId leaf;
  DepthMask straddle;
};

template <int D>
class Validator {
 public:
  explicit Validator(const Tree<D>& tree)
      : tree_(tree), stored_(tree.slots()), seen_in_(tree.table.bound()), reached_(tree.slots()) {}

  std::vector<Violation> run() {
    check_structure();
    if (!violations_.empty()) return std::move(violations_);  // a broken structure cannot be walked further
    for_each_node(tree_, tree_.root(), [this](NodeId id) {
      if (tree_[id].is_leaf()) check_leaf(id);
    });
    for_each_placed(tree_.table, [this](ObjectId object) { check_object(object); });
    check_counts();
    return std::move(violations_);
  }

 private:
  void expect(bool holds, NodeId node, const char* what) {
    if (!holds) violations_.push_back({node, what});
  }

  void check_structure() {
    expect(tree_[tree_.root()].parent.is_none(), tree_.root(), "the root has a parent");
    expect(tree_[tree_.root()].depth == 0, tree_.root(), "the root is not at depth 0");
    expect(tree_[tree_.root()].right_of == 0, tree_.root(), "the root lies right of something");
    std::vector<NodeId> todo{tree_.root()};
    std::vector<bool> seen(tree_.slots(), false);
    while (!todo.empty()) {
      const NodeId id = todo.back();
      todo.pop_back();
      const bool fresh = id.index() < seen.size() && !seen[id.index()];
      expect(fresh, id, "a link leads outside or to a node that is reached already");
      if (!fresh) return;
      seen[id.index()] = true;
      check_node(id, todo);
    }
    for (std::uint32_t slot = 0; slot < tree_.slots(); ++slot)
      expect(tree_[NodeId{slot}].alive == seen[slot], {slot},
             "a node is alive but not reached, or reached but dead");
  }

  void check_node(NodeId id, std::vector<NodeId>& todo) {
    const Node<D>& node = tree_[id];
    expect(node.left.is_none() == node.right.is_none(), id, "a node has one child");
    const bool known = node.direction < tree_.directions().size();
    const bool shallow = node.depth <= kMaxHeight;
    expect(known, id, "the direction is not in the set");
    expect(shallow, id, "the node is deeper than a mask has bits");
    if (node.is_leaf() || node.right.is_none() || !known || !shallow) return;
    expect(node.entries.empty(), id, "an inner node has entries");
    expect(std::isfinite(node.plane.offset), id, "the offset is not finite");
    expect(node.plane.normal == tree_.directions()[node.direction], id, "the normal is not its direction's");
    check_child(id, node.left, 0);
    check_child(id, node.right, depth_bit(node.depth));
    todo.push_back(node.left);
    todo.push_back(node.right);
  }

  void check_child(NodeId id, NodeId child, DepthMask side) {
    if (child.index() >= tree_.slots()) return;
    const Node<D>& node = tree_[id];
    const Node<D>& below = tree_[child];
    expect(below.parent == id, child, "the parent link is wrong");
    expect(below.depth == node.depth + 1, child, "the depth is not the parent's plus one");
    expect(below.right_of == (node.right_of | side), child, "the right-of mask is wrong");
    expect(!below.is_leaf() || below.direction == node.direction, child,
           "the list is not along the parent's normal");
  }

  void check_leaf(NodeId id) {
    const Node<D>& leaf = tree_[id];
    for (std::size_t i = 0; i < leaf.entries.size(); ++i) {
      const Entry& entry = leaf.entries[i];
      expect(tree_.table.is_placed(entry.object), id, "an entry's object is absent or quarantined");
      if (!tree_.table.is_placed(entry.object)) continue;
      const Interval key = tree_.project(leaf.direction, entry.object);
      expect(key == entry.key || leaf.unsorted, id, "an entry's key is not its projection");
      NodeId& seen_in = seen_in_[entry.object.index()];
      expect(seen_in != id, id, "an object has two entries");
      seen_in = id;
      stored_[id.index()].emplace_back(entry.object, DepthMask{entry.straddle});
      const bool ordered =
          i == 0 || leaf.entries[i - 1].key.lo < entry.key.lo ||
          (leaf.entries[i - 1].key.lo == entry.key.lo && leaf.entries[i - 1].object < entry.object);
      expect(ordered || leaf.unsorted, id, "the list is out of order");
    }
    std::ranges::sort(stored_[id.index()]);
    expected_entries_ += leaf.entries.size();
  }

  void check_object(ObjectId object) {
    std::vector<Place> todo{{tree_.root(), 0}};
    while (!todo.empty() && places_ <= expected_entries_) {  // else objects x leaves
      const auto [id, straddle] = todo.back();
      todo.pop_back();
      ++reached_[id.index()];
      const Node<D>& node = tree_[id];
      if (node.is_leaf()) {
        expect(std::ranges::binary_search(stored_[id.index()], std::pair(object, straddle)), id,
               "an object is missing here, or its straddle mask is wrong");
        ++places_;
        continue;
      }
      const Sides sides = classify(tree_.project(node.direction, object), node.plane.offset);
      const DepthMask below = straddle | (sides.straddle() ? depth_bit(node.depth) : 0);
      if (sides.left) todo.push_back({node.left, below});
      if (sides.right) todo.push_back({node.right, below});
    }
  }

  void check_counts() {
    expect(expected_entries_ == tree_.entries(), NodeId::none(), "the count of entries is wrong");
    expect(places_ == expected_entries_, NodeId::none(), "there are entries where no object belongs");
    for_each_node(tree_, tree_.root(), [this](NodeId id) {
      expect(tree_[id].population == reached_[id.index()], id, "the population is wrong");
    });
  }

  const Tree<D>& tree_;
  std::vector<std::vector<std::pair<ObjectId, DepthMask>>> stored_;  ///< by leaf, sorted
  std::vector<NodeId> seen_in_;                                      ///< by object: the last leaf that has it
  std::vector<std::uint32_t> reached_;
  std::uint64_t expected_entries_ = 0;
  std::uint64_t places_ = 0;
  std::vector<Violation> violations_;
};

}  // namespace

template <int D>
std::vector<Violation> validate(const Tree<D>& tree) {
  const DefaultFloats floats;
  return Validator<D>(tree).run();
}

template std::vector<Violation> validate<2>(const Tree<2>&);
template std::vector<Violation> validate<3>(const Tree<3>&);

}  // namespace kerf
