#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <stdexcept>
#include <variant>
#include <vector>

#include "core/c/kerf.h"
#include "core/c/sized_struct.h"
#include "core/world/world_index.h"

/// Not in a namespace: it is C's struct.
struct kerf_world {
  std::variant<kerf::World<2>, kerf::World<3>> world;
  std::variant<kerf::WorldIndex<2>, kerf::WorldIndex<3>> index;  ///< of the world's dimension
  bool steps = false;                 ///< `kerf_world_step` is running, and may have called the callback
  std::vector<kerf::ObjectDef> defs;  ///< of one call
  std::vector<kerf::WorldStatus> statuses;       ///< of one call
  mutable std::atomic<std::uint32_t> asking{0};  ///< queries that may call a callback now, of any thread
};

namespace kerf::c {

// Lists are shared with C as they are.
static_assert(sizeof(Handle) == sizeof(kerf_handle));
static_assert(sizeof(Box<2>) == 4 * sizeof(float) && sizeof(Box<3>) == 6 * sizeof(float));
static_assert(sizeof(WorldPair) == sizeof(kerf_pair) && offsetof(WorldPair, b) == offsetof(kerf_pair, b) &&
              offsetof(WorldPair, flags) == offsetof(kerf_pair, flags));
static_assert(static_cast<int>(WorldStatus::damaged) == KERF_DAMAGED &&
              static_cast<int>(WorldStatus::bad_length) == KERF_BAD_LENGTH);
static_assert(static_cast<int>(ObjectKind::sensor) == KERF_SENSOR);

// The sizes of the first versions of the structs.
constexpr std::size_t kLeastOptions = offsetof(kerf_world_options, config) + sizeof(const char*);
constexpr std::size_t kLeastObject = offsetof(kerf_object, margin) + sizeof(float);
constexpr std::size_t kLeastError = offsetof(kerf_error, text) + 16;

constexpr kerf_status to_c(WorldStatus status) {
  return status == WorldStatus::busy ? kerf_status{KERF_BUSY} : static_cast<kerf_status>(status);
}

/// Stands for whatever a callback of the caller's has thrown.
struct CallbackThrew {};
template <class Call>
auto call_back(Call call) {
  try {
    return call();
  } catch (...) {
    throw CallbackThrew{};
  }
}

/// Calls C++ for C: every exception becomes a status.
template <class Call>
kerf_status guarded(Call call) noexcept {
  try {
    return call();
  } catch (const CallbackThrew&) {
    return KERF_CALLBACK_THREW;
  } catch (const std::bad_alloc&) {
    return KERF_OUT_OF_MEMORY;
  } catch (const std::length_error&) {
    return KERF_OUT_OF_MEMORY;  // a list that no memory could hold
  } catch (const std::invalid_argument&) {
    return KERF_BAD_OPTION;
  } catch (...) {
    return KERF_INTERNAL_ERROR;
  }
}

/// Calls `call` with the World of the dimension.
template <class Call>
kerf_status with_world(const kerf_world* world, Call call) noexcept {
  if (world == nullptr) return KERF_NULL_ARGUMENT;
  return guarded([&] { return std::visit(call, world->world); });
}
template <class Call>
kerf_status change_world(kerf_world* world, Call call) noexcept {
  if (world == nullptr) return KERF_NULL_ARGUMENT;
  if (world->steps || world->asking > 0) return KERF_BUSY;
  return guarded([&] { return std::visit(call, world->world); });
}

template <class T>
bool is_missing(const T* list, std::size_t count) {
  return list == nullptr && count > 0;
}

/// A list of the caller's as what it is in C++.
template <class To, class From>
std::span<To> view(From* list, std::size_t count) {
  return {reinterpret_cast<To*>(list), count};
}

/// An object as a struct of this version.
inline kerf_object to_object(const ObjectDef& def) {
  return {sizeof(kerf_object), static_cast<std::uint32_t>(def.kind),
          def.filter.category, def.filter.mask,
          def.user_data,       def.filter.group,
          def.margin};
}

}  // namespace kerf::c
