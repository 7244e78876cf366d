#include "core/spatial/batch.h"

#include <limits>
#include <numeric>

namespace kerf {
namespace {

/// Queries that a thread should have at least.
constexpr std::size_t kFewQueries = 32;

/// Answers `queries` with `ask(query, items)`; `first[k + 1]` is how many items query k has.
template <class Item, class Ask>
void ask_some(const Slice& queries, std::vector<Item>& items, BatchResult<Item>& result, Ask ask) {
  for (std::size_t k = queries.begin; k < queries.end; ++k) {
    const std::size_t before = items.size();
    result.statuses[k] = ask(k, items);
    result.first[k + 1] = items.size() - before;
  }
}

template <class Item, class Ask>
void ask_all(std::size_t count, TaskPool& pool, BatchResult<Item>& result, Ask ask) {
  result.items.clear();
  result.first.assign(count + 1, 0);
  result.statuses.assign(count, QueryStatus::ok);
  const std::size_t pieces = pool.slices_of(count, kFewQueries);
  if (pieces <= 1) {
    ask_some({0, count}, result.items, result, ask);
  } else {
    std::vector<std::vector<Item>> found(pieces);
    pool.for_each(pieces, [&](std::size_t piece, std::size_t) {
      ask_some(slice(count, pieces, piece), found[piece], result, ask);
    });
    for (const std::vector<Item>& items : found)
      result.items.insert(result.items.end(), items.begin(), items.end());
  }
  std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
}

}  // namespace

template <int D, class Query>
void overlaps(const SpatialIndex<D>& index, std::span<const Query> queries, TaskPool& pool,
              BatchResult<ObjectId>& result, const Filter& filter) {
  ask_all(queries.size(), pool, result, [&](std::size_t k, std::vector<ObjectId>& items) {
    return index.overlaps(queries[k], items, filter);
  });
}

template <int D, class Way>
void hits(const SpatialIndex<D>& index, std::span<const Way> ways, TaskPool& pool, BatchResult<Hit>& result,
          const Filter& filter) {
  ask_all(ways.size(), pool, result,
          [&](std::size_t k, std::vector<Hit>& items) { return index.hits(ways[k], items, filter); });
}

template <int D, class Way>
void first_hits(const SpatialIndex<D>& index, std::span<const Way> ways, TaskPool& pool,
                BatchResult<Hit>& result, const Filter& filter) {
  ask_all(ways.size(), pool, result, [&](std::size_t k, std::vector<Hit>& items) {
    Hit& first = items.emplace_back(Hit{ObjectId::none(), std::numeric_limits<Scalar>::infinity()});
    return index.first_hit(ways[k], first, filter);
  });
}

template <int D>
void nearest(const SpatialIndex<D>& index, std::span<const Nearest<D>> queries, TaskPool& pool,
             BatchResult<Neighbour>& result, const Filter& filter) {
  ask_all(queries.size(), pool, result, [&](std::size_t k, std::vector<Neighbour>& items) {
    return index.nearest(queries[k], items, filter);
  });
}

#define KERF_REGION(D, QUERY)                                                                               \
  template void overlaps(const SpatialIndex<D>&, std::span<const QUERY>, TaskPool&, BatchResult<ObjectId>&, \
                         const Filter&);
#define KERF_WAY(D, WAY)                                                                               \
  template void hits(const SpatialIndex<D>&, std::span<const WAY>, TaskPool&, BatchResult<Hit>&,       \
                     const Filter&);                                                                   \
  template void first_hits(const SpatialIndex<D>&, std::span<const WAY>, TaskPool&, BatchResult<Hit>&, \
                           const Filter&);
#define KERF_INSTANTIATE(D)                                                             \
  KERF_REGION(D, Box<D>)                                                                \
  KERF_REGION(D, Sphere<D>)                                                             \
  KERF_REGION(D, Frustum<D>)                                                            \
  KERF_WAY(D, Ray<D>)                                                                   \
  KERF_WAY(D, Segment<D>)                                                               \
  KERF_WAY(D, SweptBox<D>)                                                              \
  KERF_WAY(D, Cast<D>)                                                                  \
  template void nearest(const SpatialIndex<D>&, std::span<const Nearest<D>>, TaskPool&, \
                        BatchResult<Neighbour>&, const Filter&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE
#undef KERF_WAY
#undef KERF_REGION

}  // namespace kerf
