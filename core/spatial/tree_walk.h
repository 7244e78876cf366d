#pragma once

#include <cstdint>
#include <vector>

#include "core/objects/object_table.h"
#include "core/spatial/query.h"
#include "core/tree/tree.h"

namespace kerf {

/// What a query did with a node of the tree.
enum class NodeFate : std::uint8_t {
  visited,  ///< the query reaches the bounds of what is stored below
  apart,    ///< pruned: the query does not reach the bounds
  later,    ///< pruned: what is found there comes after what is found already
};

/// One node that a query looked at.
struct NodeVisit {
  NodeId node;
  NodeFate fate = NodeFate::visited;
  std::uint32_t tested = 0;  ///< leaf: entries whose boxes were tested
  std::uint32_t found = 0;   ///< leaf: of these, objects found here first
  double key = 0;            ///< casts: t at which the bounds are reached; nearest: their squared distance
};

/// How the tree itself answers a query: which nodes it looks at, in this order, and what it finds. A node's
/// children follow it unless it is pruned. The tree has no bounds of its own: those of the boxes stored below
/// each node are collected first, so a walk costs as much as all boxes. It is for explanations and pictures;
/// `SpatialIndex` answers fast, and the same.
template <int D>
class TreeWalk {
 public:
  /// `objects`: the boxes to ask about. Objects that changed since the tree's last step stand in none of its
  /// leaves as they are now, nor do, within a step, those that are not placed yet: they are tested one by one
  /// (`waiting`).
  TreeWalk(const Tree<D>& tree, const ObjectTable<D>& objects);

  QueryStatus overlaps(const Box<D>& box, std::vector<ObjectId>& found);
  QueryStatus overlaps(const Sphere<D>& sphere, std::vector<ObjectId>& found);
  QueryStatus overlaps(const Frustum<D>& frustum, std::vector<ObjectId>& found);
  QueryStatus hits(const Cast<D>& cast, std::vector<Hit>& found);
  QueryStatus first_hit(const Cast<D>& cast, Hit& first);
  QueryStatus nearest(const Nearest<D>& nearest, std::vector<Neighbour>& found);

  /// What the last query did, the root first; nothing if it was refused.
  [[nodiscard]] const std::vector<NodeVisit>& visits() const { return visits_; }
  /// Objects that the tree does not know as they are.
  [[nodiscard]] const std::vector<ObjectId>& waiting() const { return waiting_; }
  /// The bounds of the boxes stored below a node.
  [[nodiscard]] const Box<D>& bounds(NodeId node) const { return bounds_[node.index()]; }

 private:
  template <class KeyOf, class Take>
  void walk(KeyOf key_of, Take take);
  template <class KeyOf, class Take>
  void look_into(NodeId leaf, KeyOf key_of, Take take);
  template <class KeyOf>
  [[nodiscard]] double key_below(NodeId node, KeyOf key_of) const;
  template <class Region>
  QueryStatus walk_region(const Region& region, std::vector<ObjectId>& found);

  const Tree<D>& tree_;
  const ObjectTable<D>& objects_;
  std::vector<Box<D>> bounds_;  ///< by node
  std::vector<ObjectId> waiting_;
  std::vector<NodeVisit> visits_;
  std::vector<std::uint8_t> seen_;  ///< by object: it was tested in this walk, or waits
  double bound_ = 0;                ///< what has a larger key is of no interest
};

}  // namespace kerf
