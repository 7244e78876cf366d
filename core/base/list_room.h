#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/base/tuning.h"

namespace kerf {

/// The capacity of a list of `count` elements: some more, so that elements can come and go without another
/// allocation.
constexpr std::size_t list_room(std::size_t count) {
  return count + count / tuning::kElementsPerSpare + tuning::kFewSpare;
}

/// Gives a list the room for `count` elements and keeps its first ones. A list with half as much again, as
/// when objects have left for good, gives the excess back.
template <class T>
void make_list_room(std::vector<T>& list, std::size_t count) {
  const std::size_t room = list_room(count);
  if (count <= list.capacity() && list.capacity() <= room + room / 2 + tuning::kFewSpare) return;
  std::vector<T> moved;
  moved.reserve(room);
  moved.insert(moved.end(), list.begin(),
               list.begin() + static_cast<std::ptrdiff_t>(std::min(list.size(), count)));
  list = std::move(moved);
}

/// Gives a list to which elements come bit by bit the room for `count` elements. When it has to move it gets
/// an eighth more, where std::vector would get as much again; so it is not copied too often, either.
template <class T>
void grow_list(std::vector<T>& list, std::size_t count) {
  if (count > list.capacity()) list.reserve(list_room(count + count / tuning::kElementsPerSpare));
}

/// Makes the list `count` elements long, by `grow_list`.
template <class T>
void resize_list(std::vector<T>& list, std::size_t count) {
  grow_list(list, count);
  list.resize(count);
}

}  // namespace kerf
