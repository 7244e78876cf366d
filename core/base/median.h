#pragma once

#include <algorithm>
#include <vector>

namespace kerf {

/// The median: of an even number of values, the mean of the two in the middle; 0 if there are none.
inline double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

}  // namespace kerf
