#include "frames/page/pareto.h"

#include <algorithm>

namespace kerf {

std::vector<bool> pareto_front(const std::vector<Cost>& points) {
  const auto beats = [](const Cost& a, const Cost& b) {
    return a.error <= b.error && a.time <= b.time && (a.error < b.error || a.time < b.time);
  };
  std::vector<bool> front;
  for (const Cost& point : points)
    front.push_back(
        std::none_of(points.begin(), points.end(), [&](const Cost& other) { return beats(other, point); }));
  return front;
}

}  // namespace kerf
