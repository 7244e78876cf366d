#pragma once

#include <cstdint>
#include <vector>

#include "core/base/ids.h"
#include "core/base/pair_list.h"
#include "core/geometry/box.h"

namespace kerf {

/// A cut pays while both children have together at most this many times the entries of their parent.
inline constexpr double kMostGrowth = 1.4;

/// A binary tree of cuts along the axes, on which the policies of the related work (section 2) act. A leaf
/// has every object of which a part lies in its region; a region has its lower bounds and not its upper ones.
/// A pair is found in the leaf of the point where the overlap begins, and so once.
template <int D>
class CutTree {
 public:
  static constexpr std::size_t kCrowded = 16;  ///< objects of a leaf that is worth a cut
  static constexpr std::uint32_t kDeepest = 40;
  using Index = std::uint32_t;
  static constexpr Index kNone = ~Index{0};

  struct Node {
    int axis = -1;  ///< of the cut; -1: it is a leaf
    Scalar cut = 0;
    Index parent = kNone;
    Index below = kNone;  ///< the child in front of the cut, where objects begin before it
    Index above = kNone;  ///< the other, where objects end at the cut or behind it
    std::uint32_t depth = 0;
    Box<D> region;                    ///< bounds may be infinite
    std::vector<ObjectId> entries{};  ///< of a leaf
    double tests = 0;                 ///< of boxes in this leaf, for those who count them
    double updates = 0;               ///< of its entries, likewise
    [[nodiscard]] bool is_leaf() const { return axis < 0; }
  };
  /// A place between the objects of a leaf.
  struct Cut {
    int axis = -1;  ///< -1: none divides them
    Scalar at = 0;
  };

  CutTree() { clear(); }

  /// One empty leaf.
  void clear();
  [[nodiscard]] Index root() const { return 0; }
  [[nodiscard]] const Node& operator[](Index node) const { return nodes_[node]; }
  [[nodiscard]] Node& operator[](Index node) { return nodes_[node]; }
  /// Of an object that is stored.
  [[nodiscard]] const Box<D>& box(ObjectId object) const { return boxes_[object.index()]; }
  /// Entries of all leaves.
  [[nodiscard]] std::size_t entries() const { return entries_; }
  /// About what it takes.
  [[nodiscard]] std::uint64_t bytes() const {
    return nodes_.capacity() * sizeof(Node) + boxes_.capacity() * sizeof(Box<D>) +
           entries_ * sizeof(ObjectId);
  }

  /// Stores an object below a node, and gives its new leaves to `leaves`.
  void insert(Index node, ObjectId object, const Box<D>& box, std::vector<Index>& leaves);
  /// Removes an object that is stored below the node.
  void remove(Index node, ObjectId object);
  /// Gives a stored object another box, with which it has the same leaves.
  void set_box(ObjectId object, const Box<D>& box) { boxes_[object.index()] = box; }
  /// Removes all objects; cuts stay.
  void remove_all();
  /// Divides a leaf. Both children may have all of its entries.
  void divide(Index leaf, const Cut& cut);
  /// Divides what is crowded in a leaf, until nothing more is gained.
  void divide_crowded(Index leaf);
  /// Makes an empty leaf of a node; the objects that were below it, each once.
  std::vector<ObjectId> take_out(Index node);
  /// Makes a leaf of a node, with the objects below it.
  void collapse(Index node);
  /// Gives the cut another place within the region of its node, the nearest to `at`. Only for a node that has
  /// no entries below it.
  void move_cut(Index node, Scalar at);
  /// The objects below a node, each once.
  [[nodiscard]] std::vector<ObjectId> objects_below(Index node) const;

  /// Between the centres, on the axis on which they are spread most. None if it would leave one side with
  /// nearly all of them.
  [[nodiscard]] Cut median_cut(Index leaf) const;

  template <class Visit>
  void for_each_leaf(Index node, const Visit& visit) const {
    if (nodes_[node].is_leaf()) return visit(node);
    for_each_leaf(nodes_[node].below, visit);
    for_each_leaf(nodes_[node].above, visit);
  }
  /// Compares all boxes of each leaf; the number of comparisons. `is_fixed(object)`.
  template <class IsFixed>
  std::uint64_t find_pairs(PairList& pairs, const IsFixed& is_fixed) {
    std::uint64_t tests = 0;
    for_each_leaf(root(), [&](Index leaf) {
      const std::vector<ObjectId>& entries = nodes_[leaf].entries;
      for (std::size_t i = 0; i < entries.size(); ++i)
        for (std::size_t k = i + 1; k < entries.size(); ++k)
          if (begins_in(leaf, entries[i], entries[k]) && !(is_fixed(entries[i]) && is_fixed(entries[k])))
            pairs.add(make_pair(entries[i], entries[k]));
      const std::size_t compared = entries.size() * (entries.size() - (entries.empty() ? 0 : 1)) / 2;
      nodes_[leaf].tests += static_cast<double>(compared);
      tests += compared;
    });
    return tests;
  }

 private:
  [[nodiscard]] Index make_node(Index parent, const Box<D>& region);
  void free_below(Index node);
  /// Whether two objects overlap, and where the overlap begins lies in the leaf.
  [[nodiscard]] bool begins_in(Index leaf, ObjectId a, ObjectId b) const;

  std::vector<Node> nodes_;
  std::vector<Index> free_;
  std::vector<Box<D>> boxes_;  ///< by object
  std::size_t entries_ = 0;
};

}  // namespace kerf
