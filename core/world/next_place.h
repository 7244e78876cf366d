#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/world/world.h"

namespace kerf {

/// Makes room for what the next object of a world needs beside it, in a list by index of the handle: if
/// memory ends, then before the world has the object. The index is at most one above those that there were.
template <int D, class Place>
void make_room_for_next(const World<D>& world, std::vector<Place>& places) {
  const std::size_t needed = world.tree().objects().bound() + 1;
  if (places.size() < needed) places.resize(needed);
}

/// Throws std::invalid_argument where World fails.
template <int D>
Handle insert_or_throw(World<D>& world, const Box<D>& box, const ObjectDef& def = {}) {
  const auto [status, handle] = world.insert(box, def);
  if (is_failure(status)) throw std::invalid_argument(std::string(to_string(status)));
  return handle;
}

/// Remembers the handle of what `insert()` puts into a world under its key, or, if that fails, neither.
/// False: the key is there already.
template <class Handles, class Key, class Insert>
bool add_under_key(Handles& handles, const Key& key, const Insert& insert) {
  const auto [entry, is_new] = handles.try_emplace(key);
  if (!is_new) return false;
  try {
    entry->second = insert();
  } catch (...) {
    handles.erase(entry);
    throw;
  }
  return true;
}

}  // namespace kerf
