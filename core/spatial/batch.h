#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/task_pool.h"
#include "core/spatial/query.h"
#include "core/spatial/spatial_index.h"

namespace kerf {

/// The results of many queries, one list after another.
template <class Item>
struct BatchResult {
  std::vector<Item> items;
  std::vector<std::size_t> first;     ///< by query: where its items begin; one more than queries
  std::vector<QueryStatus> statuses;  ///< by query

  /// The items of a query.
  [[nodiscard]] std::span<const Item> of(std::size_t query) const {
    return std::span(items).subspan(first[query], first[query + 1] - first[query]);
  }
};

// Many queries at once, with the results that each of them has alone; what `result` held is replaced. The
// queries are shared between the threads of the pool; `filter` is then called from several of them. `Query`
// is Box<D>, Sphere<D> or Frustum<D>; `Way` is Ray<D>, Segment<D>, SweptBox<D> or Cast<D>.

template <int D, class Query>
void overlaps(const SpatialIndex<D>& index, std::span<const Query> queries, TaskPool& pool,
              BatchResult<ObjectId>& result, const Filter& filter = {});
template <int D, class Way>
void hits(const SpatialIndex<D>& index, std::span<const Way> ways, TaskPool& pool, BatchResult<Hit>& result,
          const Filter& filter = {});
/// Each query has one item, which names no object if nothing is hit.
template <int D, class Way>
void first_hits(const SpatialIndex<D>& index, std::span<const Way> ways, TaskPool& pool,
                BatchResult<Hit>& result, const Filter& filter = {});
template <int D>
void nearest(const SpatialIndex<D>& index, std::span<const Nearest<D>> queries, TaskPool& pool,
             BatchResult<Neighbour>& result, const Filter& filter = {});

}  // namespace kerf
