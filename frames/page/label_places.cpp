#include "frames/page/label_places.h"

#include <algorithm>

namespace kerf {
namespace {

constexpr double kLetter = 6.6;  // at a size of 12
constexpr double kHalfLine = 7;
constexpr double kGap = 9;
constexpr double kPointReach = 5;

struct Rectangle {
  double left = 0;
  double top = 0;
  double right = 0;
  double bottom = 0;
};

bool meet(const Rectangle& a, const Rectangle& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

Rectangle around(const LabelWish& point) {
  return {point.x - kPointReach, point.y - kPointReach, point.x + kPointReach, point.y + kPointReach};
}

Rectangle rectangle_of(const LabelPlace& place, const std::string& text) {
  return {place.x, place.y - kHalfLine, place.x + kLetter * static_cast<double>(text.size()),
          place.y + kHalfLine};
}

/// Right and left of the point, then above and below, then farther away.
std::vector<LabelPlace> candidates(const LabelWish& wish) {
  const double width = kLetter * static_cast<double>(wish.text.size());
  std::vector<LabelPlace> places;
  for (const double rise : {0.0, -11.0, 11.0, -18.0, 18.0})
    for (const double x : {wish.x + kGap, wish.x - kGap - width, wish.x - width / 2})
      if (rise != 0 || x != wish.x - width / 2) places.push_back({x, wish.y + rise});
  return places;
}

}  // namespace

std::vector<std::optional<LabelPlace>> place_labels(const std::vector<LabelWish>& wishes,
                                                    const std::vector<LabelWish>& obstacles, double left,
                                                    double right) {
  std::vector<Rectangle> taken;
  for (const LabelWish& point : wishes) taken.push_back(around(point));
  for (const LabelWish& point : obstacles) taken.push_back(around(point));
  std::vector<std::optional<LabelPlace>> places;
  for (const LabelWish& wish : wishes) {
    places.emplace_back();
    for (const LabelPlace& place : candidates(wish)) {
      const Rectangle wanted = rectangle_of(place, wish.text);
      const bool covers = std::any_of(taken.begin(), taken.end(),
                                      [&](const Rectangle& other) { return meet(wanted, other); });
      if (covers || wanted.left < left || wanted.right > right) continue;
      places.back() = place;
      taken.push_back(wanted);
      break;
    }
  }
  return places;
}

}  // namespace kerf
