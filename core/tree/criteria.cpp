#include "core/tree/criteria.h"

#include <algorithm>
#include <cmath>

namespace kerf {

std::uint32_t split_threshold(std::uint32_t objects, const Config& config) {
  const std::uint64_t least = config.min_threshold;
  if (objects <= least * least)
    return config.min_threshold;  // a root takes longer than all else that is asked
  const auto root = static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(objects))));
  return std::clamp(root, config.min_threshold, config.max_threshold);
}

std::uint32_t merge_threshold(std::uint32_t objects, const Config& config) {
  return static_cast<std::uint32_t>(config.merge_fraction *
                                    static_cast<float>(split_threshold(objects, config)));
}

}  // namespace kerf
