#include "viz/draw/panes.h"

#include <algorithm>

namespace kerf {

namespace {

constexpr int kLeastWidth = 240;
constexpr int kLeastHeight = 200;

/// How large a scene of that aspect is in one of the panes; 0: they have no room. Words take some of it.
double size_in(int picture_width, int picture_height, int panes, int columns, double aspect) {
  constexpr double kWords = 90;  // in a picture of 720 rows
  const int rows = (panes + columns - 1) / columns;
  const double width = double{1} * picture_width / columns;
  const double height = double{1} * picture_height / rows;
  if (width < kLeastWidth || height < kLeastHeight) return 0;
  return std::min(width / aspect, height - std::min(0.4 * height, kWords * picture_height / 720));
}

}  // namespace

int choose_columns(int picture_width, int picture_height, std::size_t panes, double aspect) {
  const auto count = static_cast<int>(panes);
  int best = 1;
  double largest = 0;
  for (int columns = 1; columns <= count; ++columns) {
    const double size = size_in(picture_width, picture_height, count, columns, aspect);
    if (size <= largest) continue;
    largest = size;
    best = columns;
  }
  return best;
}

bool have_room(int picture_width, int picture_height, std::size_t panes) {
  const auto count = static_cast<int>(panes);
  for (int columns = 1; columns <= count; ++columns)
    if (size_in(picture_width, picture_height, count, columns, 1) > 0) return true;
  return false;
}

template <int D>
double aspect_of(const Box<D>& bounds) {
  constexpr double kUsual = 1.6;
  if (D == 3) return kUsual;
  const double width = double{bounds.max[0]} - bounds.min[0];
  const double height = double{bounds.max[1]} - bounds.min[1];
  return width > 0 && height > 0 ? std::clamp(width / height, 0.1, 10.0) : kUsual;
}

template double aspect_of(const Box<2>&);
template double aspect_of(const Box<3>&);

std::vector<Pair> rejected_of(std::vector<Pair> tested, const std::vector<Pair>& pairs) {
  std::ranges::sort(tested);
  tested.erase(std::unique(tested.begin(), tested.end()), tested.end());
  std::erase_if(tested, [&](const Pair& pair) { return std::ranges::binary_search(pairs, pair); });
  return tested;
}

}  // namespace kerf
