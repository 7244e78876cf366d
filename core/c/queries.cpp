// Queries, for C.

#include <algorithm>
#include <optional>

#include "core/c/call.h"

namespace kerf::c {
namespace {

static_assert(sizeof(WorldNeighbour) == sizeof(kerf_neighbour));
constexpr std::size_t kLeastFilter = offsetof(kerf_query_filter, context) + sizeof(void*);
constexpr kerf_query_filter kAll{sizeof(kerf_query_filter), 0xF, 0, 0, 0, 0, nullptr, nullptr};

/// None if all are 0. A category or mask of 0 beside another of the three would find nothing: it has all
/// bits.
std::optional<PairFilter> pair_filter(const kerf_query_filter& given) {
  if (given.category == 0 && given.mask == 0 && given.group == 0) return std::nullopt;
  const auto bits = [](std::uint64_t set) { return set == 0 ? UINT64_MAX : set; };
  return PairFilter{bits(given.category), bits(given.mask), given.group};
}

kerf_status read_filter(const kerf_query_filter* from, WorldQueryFilter& to) {
  if (from == nullptr) return KERF_OK;
  kerf_query_filter given = kAll;
  if (const kerf_status status = read_struct(from, kLeastFilter, given); status != KERF_OK) return status;
  if (given.reserved != 0) return KERF_BAD_SIZE;
  to.kinds = given.kinds;
  to.filter = pair_filter(given);
  if (given.accepts != nullptr)
    to.accepts = [given](Handle handle) {
      return call_back([&] { return given.accepts(given.context, handle.value) != 0; });
    };
  return KERF_OK;
}

/// While it lives, the world takes no changes if the query asks a callback: that must not make any.
class Asking {
 public:
  Asking(const kerf_world& world, bool asks) : asking_(world.asking), asks_(asks) {
    if (asks_) ++asking_;
  }
  ~Asking() {
    if (asks_) --asking_;
  }
  Asking(const Asking&) = delete;
  Asking& operator=(const Asking&) = delete;

 private:
  std::atomic<std::uint32_t>& asking_;
  bool asks_;
};

template <int D>
Vector<D> read_vector(const float* from) {
  Vector<D> vector;
  std::copy_n(from, D, vector.value.begin());
  return vector;
}

/// The index of the dimension.
template <int D>
const WorldIndex<D>& index_of(const kerf_world* world) {
  return std::get<WorldIndex<D>>(world->index);
}

/// Calls `query(world, index, filter, found)` and writes what it found, as `to` makes it for C.
template <class Item, class To, class Query, class Convert>
kerf_status ask(const kerf_world* world, const kerf_query_filter* filter, To* found, std::size_t capacity,
                std::size_t* count, Query query, Convert convert) {
  if (count == nullptr || is_missing(found, capacity)) return KERF_NULL_ARGUMENT;
  return with_world(world, [&]<int D>(const World<D>& body) -> kerf_status {
    WorldQueryFilter allowed;
    if (const kerf_status status = read_filter(filter, allowed); status != KERF_OK) return status;
    const Asking asking(*world, static_cast<bool>(allowed.accepts));
    std::vector<Item> items;
    if (query(body, index_of<D>(world), allowed, items) != QueryStatus::ok) return KERF_BAD_QUERY;
    *count = items.size();
    const std::size_t written = std::min(capacity, items.size());
    std::transform(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(written), found, convert);
    return written == items.size() || capacity == 0 ? KERF_OK : KERF_SMALL_BUFFER;
  });
}

kerf_handle handle_of(Handle handle) { return handle.value; }
kerf_hit hit_of(const WorldHit& hit) { return {hit.object.value, hit.t, 0}; }
kerf_neighbour neighbour_of(const WorldNeighbour& neighbour) {
  return {neighbour.object.value, neighbour.squared_distance};
}

template <int D>
Cast<D> read_cast(const float* box, const float* direction, float max_t) {
  return SweptBox<D>{{read_vector<D>(box), read_vector<D>(box + D)}, read_vector<D>(direction), max_t};
}

}  // namespace
}  // namespace kerf::c

using kerf::Handle;
using kerf::World;
using kerf::WorldIndex;
using kerf::WorldQueryFilter;

kerf_status kerf_query_filter_init(kerf_query_filter* filter, size_t size) {
  if (filter == nullptr) return KERF_NULL_ARGUMENT;
  return kerf::c::write_struct(kerf::c::kAll, size, kerf::c::kLeastFilter, filter);
}

kerf_status kerf_world_update_index(kerf_world* world) {
  return kerf::c::change_world(world, [world]<int D>(const World<D>& body) -> kerf_status {
    std::get<WorldIndex<D>>(world->index).update(body);
    return KERF_OK;
  });
}

kerf_status kerf_world_overlap_box(const kerf_world* world, const float* box, const kerf_query_filter* filter,
                                   kerf_handle* found, size_t capacity, size_t* count) {
  if (box == nullptr) return KERF_NULL_ARGUMENT;
  const auto query = [box]<int D>(const World<D>& body, const WorldIndex<D>& index,
                                  const WorldQueryFilter& allowed, std::vector<Handle>& items) {
    const kerf::Box<D> region{kerf::c::read_vector<D>(box), kerf::c::read_vector<D>(box + D)};
    return index.overlaps(body, region, items, allowed);
  };
  return kerf::c::ask<Handle>(world, filter, found, capacity, count, query, kerf::c::handle_of);
}

kerf_status kerf_world_overlap_sphere(const kerf_world* world, const float* center, float radius,
                                      const kerf_query_filter* filter, kerf_handle* found, size_t capacity,
                                      size_t* count) {
  if (center == nullptr) return KERF_NULL_ARGUMENT;
  const auto query = [=]<int D>(const World<D>& body, const WorldIndex<D>& index,
                                const WorldQueryFilter& allowed, std::vector<Handle>& items) {
    const kerf::Sphere<D> region{kerf::c::read_vector<D>(center), radius};
    return index.overlaps(body, region, items, allowed);
  };
  return kerf::c::ask<Handle>(world, filter, found, capacity, count, query, kerf::c::handle_of);
}

kerf_status kerf_world_cast(const kerf_world* world, const float* box, const float* direction, float max_t,
                            const kerf_query_filter* filter, kerf_hit* found, size_t capacity,
                            size_t* count) {
  if (box == nullptr || direction == nullptr) return KERF_NULL_ARGUMENT;
  const auto query = [=]<int D>(const World<D>& body, const WorldIndex<D>& index,
                                const WorldQueryFilter& allowed, std::vector<kerf::WorldHit>& items) {
    return index.hits(body, kerf::c::read_cast<D>(box, direction, max_t), items, allowed);
  };
  return kerf::c::ask<kerf::WorldHit>(world, filter, found, capacity, count, query, kerf::c::hit_of);
}

kerf_status kerf_world_cast_first(const kerf_world* world, const float* box, const float* direction,
                                  float max_t, const kerf_query_filter* filter, kerf_hit* first) {
  if (box == nullptr || direction == nullptr || first == nullptr) return KERF_NULL_ARGUMENT;
  const auto query = [=]<int D>(const World<D>& body, const WorldIndex<D>& index,
                                const WorldQueryFilter& allowed, std::vector<kerf::WorldHit>& items) {
    return index.first_hit(body, kerf::c::read_cast<D>(box, direction, max_t), items.emplace_back(), allowed);
  };
  std::size_t count = 0;
  return kerf::c::ask<kerf::WorldHit>(world, filter, first, 1, &count, query, kerf::c::hit_of);
}

kerf_status kerf_world_nearest(const kerf_world* world, const float* point, float max_distance,
                               const kerf_query_filter* filter, kerf_neighbour* found, size_t capacity,
                               size_t* count) {
  if (point == nullptr) return KERF_NULL_ARGUMENT;
  const auto query = [=]<int D>(const World<D>& body, const WorldIndex<D>& index,
                                const WorldQueryFilter& allowed, std::vector<kerf::WorldNeighbour>& items) {
    const std::size_t most = std::min(capacity, body.size());
    const kerf::Nearest<D> nearest{kerf::c::read_vector<D>(point), most, max_distance};
    return index.nearest(body, nearest, items, allowed);
  };
  return kerf::c::ask<kerf::WorldNeighbour>(world, filter, found, capacity, count, query,
                                            kerf::c::neighbour_of);
}
