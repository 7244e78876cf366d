#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace kerf {

/// Sees to it that a list has memory for `count` things, of which the first that are there stay. There is
/// room for an eighth and eight more, so that what comes and goes needs no other memory; what has half as
/// much again as that and more, as when objects have gone to other leaves for good, gives it back.
template <class T>
void make_list_room(std::vector<T>& list, std::size_t count) {
  constexpr std::size_t kFew = 8;
  const std::size_t room = count + count / 8 + kFew;
  if (count <= list.capacity() && list.capacity() <= room + room / 2 + kFew) return;
  std::vector<T> moved;
  moved.reserve(room);
  moved.insert(moved.end(), list.begin(),
               list.begin() + static_cast<std::ptrdiff_t>(std::min(list.size(), count)));
  list = std::move(moved);
}

}  // namespace kerf
