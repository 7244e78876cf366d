#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace kerf {

/// Delta debugging (Zeller and Hildebrandt 2002, ddmin): leaves out ever smaller parts of `items` as long as
/// `fails(rest)` still holds. The result fails, and without any one of its items it does not; one is left.
///
/// Pre: fails(items). `fails` is called O(n^2) times at worst, O(log n) times if one item is to blame.
template <class Item, class Fails>
std::vector<Item> delta_debug(std::vector<Item> items, Fails fails) {
  std::size_t parts = 2;
  while (items.size() >= 2) {
    bool smaller = false;
    for (std::size_t part = 0; part < parts && !smaller; ++part) {
      const auto begin = static_cast<std::ptrdiff_t>(part * items.size() / parts);
      const auto end = static_cast<std::ptrdiff_t>((part + 1) * items.size() / parts);
      std::vector<Item> rest(items.begin(), items.begin() + begin);
      rest.insert(rest.end(), items.begin() + end, items.end());
      if (!fails(rest)) continue;
      items = std::move(rest);
      smaller = true;
    }
    if (smaller) {
      parts = std::max<std::size_t>(parts - 1, 2);
    } else if (parts >= items.size()) {
      break;
    } else {
      parts = std::min(2 * parts, items.size());
    }
  }
  return items;
}

}  // namespace kerf
