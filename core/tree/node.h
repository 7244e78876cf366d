#pragma once

#include <cstdint>
#include <vector>

#include "core/base/ids.h"
#include "core/geometry/plane.h"
#include "core/objects/entry.h"

namespace kerf {

/// A node of the tree: either inner (a partitioner and two children) or a leaf (entries). All nodes live in
/// one array; links are indices. It has many fields, since a node is a row of the tree's table: all that is
/// known of it is here.
template <int D>
struct Node {
  Plane<D> plane;               ///< inner: objects with lo <= d are left, with hi > d right
  std::uint32_t direction = 0;  ///< inner: index of the plane's normal in the direction set;
                                ///< leaf: direction of the ordered list, the parent's (root leaf: 0)
  NodeId parent;
  NodeId left;  ///< none: this node is a leaf
  NodeId right;
  std::uint32_t generation = 0;  ///< counts the lives of this slot
  std::uint32_t depth = 0;
  std::uint32_t population = 0;  ///< different objects stored below
  DepthMask right_of = 0;        ///< bit k: lies right of the ancestor at depth k
  std::uint32_t retry_step = 0;  ///< leaf: no split is tried before this step (back-off after refusals)
  std::uint32_t refusals = 0;    ///< leaf: splits refused in a row
  bool alive = false;
  bool unsorted = false;       ///< leaf: the entries' keys and order must be renewed before they are read
  std::uint32_t version = 0;   ///< leaf: grows whenever its entries or masks change
  std::vector<Entry> entries;  ///< leaf: ordered by (key.lo, object) after the sort phase

  [[nodiscard]] bool is_leaf() const { return left.is_none(); }
};

}  // namespace kerf
