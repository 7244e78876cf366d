#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/c/kerf.h"

namespace kerf::c {

/// No version of a struct is larger: a size beyond it was never set.
constexpr std::size_t kMostSize = 4096;

/// Reads a struct that begins with its size: of an older caller without its last members, which get defaults,
/// or of a newer one, whose further members must be 0. `least`: the size of its first version.
template <class Struct>
kerf_status read_struct(const void* from, std::size_t least, Struct& to) {
  static_assert(sizeof(Struct) <= kMostSize);
  std::uint32_t size = 0;
  std::memcpy(&size, from, sizeof size);
  if (size < least || size > kMostSize) return KERF_BAD_SIZE;
  const auto* const bytes = static_cast<const unsigned char*>(from);
  const auto is_set = [](unsigned char byte) { return byte != 0; };
  if (size > sizeof to && std::any_of(bytes + sizeof to, bytes + size, is_set)) return KERF_BAD_SIZE;
  std::memcpy(&to, from, std::min<std::size_t>(size, sizeof to));
  return KERF_OK;
}

/// Writes as much of a struct as the caller's has, and the caller's size; members that this version does not
/// know become 0.
template <class Struct>
kerf_status write_struct(Struct from, std::size_t size, std::size_t least, void* to) {
  static_assert(sizeof(Struct) <= kMostSize);
  if (size < least || size > kMostSize) return KERF_BAD_SIZE;
  from.size = static_cast<std::uint32_t>(size);
  if (size > sizeof from) std::memset(to, 0, size);
  std::memcpy(to, &from, std::min(size, sizeof from));
  return KERF_OK;
}

}  // namespace kerf::c
