#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/query/asked_query.h"
#include "core/replay/position.h"
#include "core/replay/replayer.h"
#include "core/spatial/tree_walk.h"

namespace kerf {

/// A node that a query looked at.
template <int D>
struct QueryVisit {
  NodeVisit visit;
  std::uint32_t depth = 0;
  bool is_leaf = false;
  Plane<D> plane;  ///< inner: its partitioner
  Box<D> bounds;   ///< of the boxes stored below
};

/// An object that answers a query.
struct FoundObject {
  ObjectId object;
  double key = 0;  ///< a ray's t; of the nearest the distance; else 0
};

/// How the tree answers a query, and what it finds.
template <int D>
struct QueryExplanation {
  Position at;
  AskedQuery<D> query;
  QueryStatus status = QueryStatus::ok;
  std::uint32_t objects = 0;  ///< that can be found
  std::uint32_t waiting = 0;  ///< of them, those that the tree does not know as they are
  std::vector<FoundObject>
      found;  ///< of a ray all that it hits; in order of their keys, then of their numbers
  std::vector<QueryVisit<D>> visits;  ///< of a ray until its first hit is known, in this order

  [[nodiscard]] std::size_t pruned() const;
  [[nodiscard]] std::size_t tested() const;  ///< boxes, in the leaves that were visited
};

template <int D>
QueryExplanation<D> explain_query(const Tree<D>& tree, const ObjectTable<D>& objects,
                                  const AskedQuery<D>& query);

/// At the end of a step. Throws std::runtime_error for a step that the recording does not have.
template <int D>
QueryExplanation<D> explain_query(Replayer<D>& replayer, std::uint32_t step, const AskedQuery<D>& query);

/// The explanation in sentences, a line each.
template <int D>
std::string to_text(const QueryExplanation<D>& explanation, const GivenNames& names);

/// "ray: 3 hit, 5 of 9 nodes visited, 14 boxes tested"
template <int D>
std::string summary(const QueryExplanation<D>& explanation);

}  // namespace kerf
