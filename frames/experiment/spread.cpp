#include "frames/experiment/spread.h"

#include <algorithm>
#include <cmath>

#include "core/base/median.h"
#include "frames/page/short_number.h"

namespace kerf {

std::optional<Spread> spread_of(std::vector<double> samples) {
  if (samples.empty() || std::ranges::any_of(samples, [](double x) { return std::isnan(x); }))
    return std::nullopt;
  std::ranges::sort(samples);
  const std::size_t count = samples.size();
  const std::size_t dropped = count / 10;
  return Spread{median(samples), samples[dropped], samples[count - 1 - dropped], count};
}

std::string text_of(const Spread& spread) {
  const std::string low = short_number(spread.low);
  const std::string high = short_number(spread.high);
  return short_number(spread.median) + (low == high ? "" : " (" + low + " to " + high + ")");
}

}  // namespace kerf
