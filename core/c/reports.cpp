// What a world says of itself, for C.

#include <cstring>
#include <optional>

#include "core/c/call.h"

namespace kerf::c {
namespace {

template <int D>
kerf_status write_box(const std::optional<Box<D>>& box, float* to) {
  if (!box) return KERF_STALE_HANDLE;
  std::memcpy(to, &*box, sizeof *box);
  return KERF_OK;
}

kerf_status give(std::span<const WorldPair> report, const kerf_pair** pairs, std::size_t* count) {
  *pairs = reinterpret_cast<const kerf_pair*>(report.data());
  *count = report.size();
  return KERF_OK;
}

}  // namespace
}  // namespace kerf::c

using kerf::c::is_missing;
using kerf::c::with_world;

kerf_status kerf_world_pairs(const kerf_world* world, const kerf_pair** pairs, size_t* count) {
  if (pairs == nullptr || count == nullptr) return KERF_NULL_ARGUMENT;
  return with_world(world, [=](const auto& body) { return kerf::c::give(body.pairs(), pairs, count); });
}

kerf_status kerf_world_begun(const kerf_world* world, const kerf_pair** pairs, size_t* count) {
  if (pairs == nullptr || count == nullptr) return KERF_NULL_ARGUMENT;
  return with_world(world, [=](const auto& body) { return kerf::c::give(body.begun(), pairs, count); });
}

kerf_status kerf_world_ended(const kerf_world* world, const kerf_pair** pairs, size_t* count) {
  if (pairs == nullptr || count == nullptr) return KERF_NULL_ARGUMENT;
  return with_world(world, [=](const auto& body) { return kerf::c::give(body.ended(), pairs, count); });
}

uint32_t kerf_world_dimension(const kerf_world* world) {
  std::uint32_t dimension = 0;
  (void)with_world(world, [&]<int D>(const kerf::World<D>&) -> kerf_status {
    dimension = D;
    return KERF_OK;
  });
  return dimension;
}

size_t kerf_world_size(const kerf_world* world) {
  std::size_t size = 0;
  (void)with_world(world, [&](const auto& body) -> kerf_status {
    size = body.size();
    return KERF_OK;
  });
  return size;
}

size_t kerf_world_bound(const kerf_world* world) {
  std::size_t bound = 0;
  (void)with_world(world, [&](const auto& body) -> kerf_status {
    bound = body.bound();
    return KERF_OK;
  });
  return bound;
}

uint32_t kerf_handle_index(kerf_handle handle) { return kerf::Handle{handle}.index(); }

kerf_status kerf_world_contains(const kerf_world* world, kerf_handle handle) {
  return with_world(world, [=](const auto& body) -> kerf_status {
    return body.contains({handle}) ? KERF_OK : KERF_STALE_HANDLE;
  });
}

kerf_status kerf_world_get_object(const kerf_world* world, kerf_handle handle, kerf_object* object) {
  if (object == nullptr) return KERF_NULL_ARGUMENT;
  return with_world(world, [=](const auto& body) -> kerf_status {
    const kerf::ObjectDef* const def = body.find({handle});
    if (def == nullptr) return KERF_STALE_HANDLE;
    return kerf::c::write_struct(kerf::c::to_object(*def), object->size, kerf::c::kLeastObject, object);
  });
}

kerf_status kerf_world_get_box(const kerf_world* world, kerf_handle handle, float* box) {
  if (box == nullptr) return KERF_NULL_ARGUMENT;
  return with_world(world, [=](const auto& body) { return kerf::c::write_box(body.box({handle}), box); });
}

kerf_status kerf_world_get_fat_box(const kerf_world* world, kerf_handle handle, float* box) {
  if (box == nullptr) return KERF_NULL_ARGUMENT;
  return with_world(world, [=](const auto& body) { return kerf::c::write_box(body.fat_box({handle}), box); });
}

kerf_status kerf_world_get_handles(const kerf_world* world, kerf_handle* handles, size_t capacity,
                                   size_t* count) {
  if (count == nullptr || is_missing(handles, capacity)) return KERF_NULL_ARGUMENT;
  return with_world(world, [=](const auto& body) -> kerf_status {
    *count = body.size();
    if (capacity < body.size()) return capacity == 0 ? KERF_OK : KERF_SMALL_BUFFER;
    kerf_handle* next = handles;
    body.for_each([&next](kerf::Handle handle) { *next++ = handle.value; });
    return KERF_OK;
  });
}
