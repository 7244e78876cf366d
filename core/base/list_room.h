#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace kerf {

/// Gives a list memory for `count` elements and keeps its first ones. The room is an eighth and eight more
/// than needed, so that elements can come and go without another allocation. A list with half as much again
/// as that, as when objects have left for good, gives the excess back.
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
