#include "viz/draw/panes.h"

#include <algorithm>

namespace kerf {

PaneShape shape_of(std::size_t panes) {
  const int rows = panes <= 3 ? 1 : 2;
  return {(static_cast<int>(panes) + rows - 1) / rows, rows};
}

bool have_room(int picture_width, int picture_height, std::size_t panes) {
  constexpr int kLeastWidth = 240;
  constexpr int kLeastHeight = 200;
  const PaneShape shape = shape_of(panes);
  return picture_width >= kLeastWidth * shape.columns && picture_height >= kLeastHeight * shape.rows;
}

std::vector<Pair> rejected_of(std::vector<Pair> tested, const std::vector<Pair>& pairs) {
  std::ranges::sort(tested);
  const auto same = std::ranges::unique(tested);
  tested.erase(same.begin(), same.end());
  std::erase_if(tested, [&](const Pair& pair) { return std::ranges::binary_search(pairs, pair); });
  return tested;
}

}  // namespace kerf
