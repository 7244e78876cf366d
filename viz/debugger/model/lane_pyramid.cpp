#include "viz/debugger/model/lane_pyramid.h"

#include <cmath>

namespace kerf {

LanePyramid::LanePyramid(std::span<const float> values) {
  std::vector<LaneRange> level;
  level.reserve(values.size());
  for (const float value : values)
    level.push_back(std::isfinite(value) ? LaneRange{value, value} : LaneRange{});
  while (true) {
    levels_.push_back(std::move(level));
    const std::vector<LaneRange>& below = levels_.back();
    if (below.size() <= 1) return;
    level.assign((below.size() + kBlock - 1) / kBlock, LaneRange{});
    for (std::size_t k = 0; k < below.size(); ++k) level[k / kBlock].add(below[k]);
  }
}

LaneRange LanePyramid::range(std::size_t first, std::size_t last) const {
  LaneRange range;
  for_each_block(first, last, [&](const LaneRange& block) { range.add(block); });
  return range;
}

}  // namespace kerf
