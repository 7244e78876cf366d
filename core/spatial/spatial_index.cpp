#include "core/spatial/spatial_index.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <functional>
#include <limits>
#include <span>

#include "core/base/float_mode.h"
#include "core/kernels/search_blocks.h"
#include "core/kernels/sort_found.h"
#include "core/spatial/block_query.h"
#include "core/spatial/found_numbers.h"
#include "core/spatial/touch.h"

namespace kerf {
namespace {

static_assert(sizeof(ObjectId) == sizeof(std::uint32_t));
void sort_objects(std::span<ObjectId> objects) {
  sort_found({reinterpret_cast<std::uint32_t*>(objects.data()), objects.size()});
}

// As one number, t is above the object, and the bits of floats that are not negative grow with them.
static_assert(std::endian::native == std::endian::little && sizeof(Hit) == sizeof(HitNumber) &&
              offsetof(Hit, t) == sizeof(HitNumber) / 2);
HitNumber number_of(const Hit& hit) { return std::bit_cast<HitNumber>(hit); }
void sort_hits(std::span<Hit> hits) {
  sort_found({reinterpret_cast<std::uint64_t*>(hits.data()), hits.size()});
}

template <int D>
Box<D> box_in(const BlockHierarchy<D>& blocks, std::uint32_t slot) {
  return blocks.blocks()[slot / kBlockWidth].box(slot % kBlockWidth);
}
template <int D>
ObjectId object_in(const BlockHierarchy<D>& blocks, std::uint32_t slot) {
  return {blocks.blocks()[slot / kBlockWidth].item[slot % kBlockWidth]};
}

/// Calls `take(slot)` for all objects, until it returns false.
template <int D, class Take>
void for_each_slot(const BlockHierarchy<D>& blocks, Take take) {
  for (std::size_t block = 0; block < blocks.blocks().size(); ++block) {
    if (!blocks.has_objects(block)) continue;
    for (std::size_t k = 0; k < kBlockWidth; ++k)
      if (!blocks.blocks()[block].is_empty(k) && !take(static_cast<std::uint32_t>(block * kBlockWidth + k)))
        return;
  }
}

using Ids = std::span<const std::uint32_t>;

ObjectId object_of(ObjectId object) { return object; }
ObjectId object_of(const Hit& hit) { return hit.object; }

/// Appends the numbers whose objects take part, as values of the same bits.
template <class Number, class Value>
void append_taken(std::span<const Number> numbers, const Filter& filter, std::vector<Value>& found) {
  const bool takes_all = filter.takes_all();
  for (const Number number : numbers) {
    const auto value = std::bit_cast<Value>(number);
    if (takes_all || filter.takes(object_of(value))) found.push_back(value);
  }
}

/// Calls `take(ids)` with the objects whose boxes the query touches, part by part, until it returns false.
template <int D, class Query, class Test, class Take>
void find_touched(const BlockHierarchy<D>& blocks, const Query& query, const Test& test, HandOn when,
                  Take take) {
  const auto touches_slot = [&](std::uint32_t slot) { return touches(query, box_in(blocks, slot)); };
  if (!test.works) {
    for_each_slot(blocks, [&](std::uint32_t slot) {
      const std::uint32_t id = object_in(blocks, slot).value;
      return !touches_slot(slot) || take(Ids(&id, 1));
    });
    return;
  }
  find_numbers<std::uint32_t>(
      when, [&](FoundRoom<std::uint32_t>& room) { find_possible(blocks.view(), test.test, room); }, take,
      touches_slot);
}

template <int D, class Take>
void find_touched(const BlockHierarchy<D>& blocks, const Sphere<D>& sphere, HandOn when, Take take) {
  const NearestRounding rounding;
  find_touched(blocks, sphere, SphereQuery<D>(sphere), when, take);
}
template <int D, class Take>
void find_touched(const BlockHierarchy<D>& blocks, const Cast<D>& cast, HandOn when, Take take) {
  const NearestRounding rounding;
  find_touched(blocks, cast, CastQuery<D>(cast), when, take);
}
template <int D, class Take>
void find_touched(const BlockHierarchy<D>& blocks, const Frustum<D>& frustum, HandOn when, Take take) {
  const NearestRounding rounding;
  find_touched(blocks, frustum, FrustumQuery<D>(frustum), when, take);
}

/// No object is at infinity, but empty slots are.
template <int D>
Box<D> clamp_to_finite(Box<D> box) {
  constexpr Scalar kMax = std::numeric_limits<Scalar>::max();
  for (int i = 0; i < D; ++i) {
    box.min[i] = std::max(box.min[i], -kMax);
    box.max[i] = std::min(box.max[i], kMax);
  }
  return box;
}

template <int D, class Take>
void find_touched(const BlockHierarchy<D>& blocks, const Box<D>& box, HandOn when, Take take) {
  const UsualComparisons comparisons;
  const Box<D> region = clamp_to_finite(box);
  find_numbers<std::uint32_t>(
      when, [&](FoundRoom<std::uint32_t>& room) { find_overlaps(blocks.view(), region, room); }, take);
}

template <int D, class Region>
QueryStatus append_overlaps(const BlockHierarchy<D>& blocks, const Region& region,
                            std::vector<ObjectId>& found, const Filter& filter) {
  const QueryStatus status = check(region);
  if (status != QueryStatus::ok) return status;
  const std::size_t before = found.size();
  find_touched(blocks, region, HandOn::in_bulk, [&](Ids ids) {
    append_taken(ids, filter, found);
    return true;
  });
  sort_objects(std::span(found).subspan(before));
  return status;
}

template <int D, class Query>
QueryStatus visit_touched(const BlockHierarchy<D>& blocks, const Query& query, const Visitor& visitor,
                          const Filter& filter) {
  const QueryStatus status = check(query);
  if (status != QueryStatus::ok) return status;
  find_touched(blocks, query, HandOn::at_once, [&](Ids ids) {
    return std::ranges::all_of(
        ids, [&](std::uint32_t id) { return !filter.takes({id}) || visitor.visit(visitor.context, {id}); });
  });
  return status;
}

/// Calls `take(hits)` with what a cast hits, part by part.
template <int D, class Take>
void find_all_hits(const BlockHierarchy<D>& blocks, const Cast<D>& cast, Take take) {
  const NearestRounding rounding;
  const CastQuery<D> query(cast);
  const auto touches_slot = [&](std::uint32_t slot) { return touches(cast, box_in(blocks, slot)); };
  if (!query.works) {
    for_each_slot(blocks, [&](std::uint32_t slot) {
      if (!touches_slot(slot)) return true;
      const HitNumber hit = number_of({object_in(blocks, slot), entry_of(cast, box_in(blocks, slot))});
      return take(std::span(&hit, 1));
    });
    return;
  }
  find_numbers<HitNumber>(
      HandOn::in_bulk, [&](FoundRoom<HitNumber>& room) { find_hits(blocks.view(), query.test, room); }, take,
      touches_slot);
}

/// The least hit so far.
template <int D>
struct FirstSearch : NearRoom {
  const BlockHierarchy<D>& blocks;
  const Cast<D>& cast;
  const Filter& filter;
  Hit& first;

  FirstSearch(const BlockHierarchy<D>& in, const Cast<D>& of, const Filter& with, Hit& found)
      : blocks(in), cast(of), filter(with), first(found) {
    first = {ObjectId::none(), std::numeric_limits<Scalar>::infinity()};
    bound = cast.max_t;
    consider = [](NearRoom& room, SlotCode code) {
      auto& search = static_cast<FirstSearch&>(room);
      return search.take(slot_of(code), is_doubtful(code));
    };
  }
  Scalar take(std::uint32_t slot, bool doubtful) {
    const Box<D> box = box_in(blocks, slot);
    if (doubtful && !touches(cast, box)) return bound;
    const Hit hit{object_in(blocks, slot), entry_of(cast, box)};
    if (number_of(hit) >= number_of(first) || !filter.takes(hit.object)) return bound;
    first = hit;
    constexpr Scalar kMax = std::numeric_limits<Scalar>::max();  // or larger
    return hit.t < kMax ? hit.t : std::numeric_limits<Scalar>::infinity();
  }
};

/// Up to so many of the nearest are kept in order: that takes less time than a heap.
constexpr std::size_t kMostInOrder = 32;

/// The nearest objects so far: in order, or many as a heap with the farthest on top.
template <int D>
struct NearestSearch : NearRoom {
  const BlockHierarchy<D>& blocks;
  const Nearest<D>& query;
  const Filter& filter;
  std::vector<Neighbour>& found;
  std::size_t before;

  NearestSearch(const BlockHierarchy<D>& in, const Nearest<D>& of, const Filter& with,
                std::vector<Neighbour>& into)
      : blocks(in), query(of), filter(with), found(into), before(into.size()) {
    const double reach = static_cast<double>(query.max_distance);
    bound = bound_above(reach * reach);
    consider = [](NearRoom& room, SlotCode code) {
      return static_cast<NearestSearch&>(room).take(slot_of(code));
    };
  }
  Scalar take(std::uint32_t slot) {
    const Box<D> box = box_in(blocks, slot);
    if (box.min[0] > box.max[0]) return bound;
    const Neighbour next{object_in(blocks, slot), squared_distance(query.point, box)};
    if ((is_full() && !(next < farthest())) || !is_within_reach(box) || !filter.takes(next.object))
      return bound;
    is_heap() ? add_to_heap(next) : add_in_order(next);
    return is_full() ? bound_above(farthest().squared_distance) : bound;
  }
  void finish() {
    if (is_heap()) std::ranges::sort_heap(all(), std::less<>());
  }

 private:
  [[nodiscard]] bool is_heap() const { return query.count > kMostInOrder; }
  [[nodiscard]] bool is_full() const { return found.size() - before == query.count; }
  [[nodiscard]] std::span<Neighbour> all() const { return std::span(found).subspan(before); }
  [[nodiscard]] const Neighbour& farthest() const { return is_heap() ? found[before] : found.back(); }
  [[nodiscard]] bool is_within_reach(const Box<D>& box) const {
    return std::isinf(query.max_distance) || touches(Sphere<D>{query.point, query.max_distance}, box);
  }
  void add_in_order(const Neighbour& next) {
    if (!is_full()) found.push_back(next);
    std::size_t place = found.size() - 1;
    for (; place > before && next < found[place - 1]; --place) found[place] = found[place - 1];
    found[place] = next;
  }
  void add_to_heap(const Neighbour& next) {
    if (is_full()) {
      std::ranges::pop_heap(all(), std::less<>());
      found.back() = next;
    } else {
      found.push_back(next);
    }
    std::ranges::push_heap(all(), std::less<>());
  }
};

}  // namespace

template <int D>
QueryStatus SpatialIndex<D>::overlaps(const Box<D>& box, std::vector<ObjectId>& found,
                                      const Filter& filter) const {
  return append_overlaps(hierarchy_, box, found, filter);
}

template <int D>
QueryStatus SpatialIndex<D>::overlaps(const Sphere<D>& sphere, std::vector<ObjectId>& found,
                                      const Filter& filter) const {
  return append_overlaps(hierarchy_, sphere, found, filter);
}

template <int D>
QueryStatus SpatialIndex<D>::overlaps(const Frustum<D>& frustum, std::vector<ObjectId>& found,
                                      const Filter& filter) const {
  return append_overlaps(hierarchy_, frustum, found, filter);
}

template <int D>
QueryStatus SpatialIndex<D>::hits(const Cast<D>& cast, std::vector<Hit>& found, const Filter& filter) const {
  const QueryStatus status = check(cast);
  if (status != QueryStatus::ok) return status;
  const std::size_t before = found.size();
  find_all_hits(hierarchy_, cast, [&](std::span<const HitNumber> numbers) {
    append_taken(numbers, filter, found);
    return true;
  });
  sort_hits(std::span(found).subspan(before));
  return status;
}

template <int D>
QueryStatus SpatialIndex<D>::first_hit(const Cast<D>& cast, Hit& first, const Filter& filter) const {
  const QueryStatus status = check(cast);
  if (status != QueryStatus::ok) return status;
  const NearestRounding rounding;
  FirstSearch<D> search(hierarchy_, cast, filter, first);
  const CastQuery<D> query(cast);
  if (query.works) {
    find_near(hierarchy_.view(), query.test, search);
  } else {
    for_each_slot(hierarchy_, [&](std::uint32_t slot) {
      search.bound = search.take(slot, true);
      return true;
    });
  }
  return status;
}

template <int D>
QueryStatus SpatialIndex<D>::nearest(const Nearest<D>& nearest, std::vector<Neighbour>& found,
                                     const Filter& filter) const {
  const QueryStatus status = check(nearest);
  if (status != QueryStatus::ok || nearest.count == 0) return status;
  const NearestRounding rounding;
  NearestSearch<D> search(hierarchy_, nearest, filter, found);
  const SphereQuery<D> query({nearest.point, 0});
  if (query.works) {
    BallTest<D> test = query.test;
    test.possible = search.bound;
    find_near(hierarchy_.view(), test, search);
  } else {
    for_each_slot(hierarchy_, [&](std::uint32_t slot) {
      search.bound = search.take(slot);
      return true;
    });
  }
  search.finish();
  return status;
}

template <int D>
QueryStatus SpatialIndex<D>::visit(const Box<D>& box, const Visitor& visitor, const Filter& filter) const {
  return visit_touched(hierarchy_, box, visitor, filter);
}

template <int D>
QueryStatus SpatialIndex<D>::visit(const Sphere<D>& sphere, const Visitor& visitor,
                                   const Filter& filter) const {
  return visit_touched(hierarchy_, sphere, visitor, filter);
}

template <int D>
QueryStatus SpatialIndex<D>::visit(const Frustum<D>& frustum, const Visitor& visitor,
                                   const Filter& filter) const {
  return visit_touched(hierarchy_, frustum, visitor, filter);
}

template <int D>
QueryStatus SpatialIndex<D>::visit(const Cast<D>& cast, const Visitor& visitor, const Filter& filter) const {
  return visit_touched(hierarchy_, cast, visitor, filter);
}

template class SpatialIndex<2>;
template class SpatialIndex<3>;

}  // namespace kerf
