#include "viz/debugger/model/ribbons.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace kerf {

std::vector<Ribbon> thin_out(std::span<const Ribbon> ribbons, const TimeScale& scale) {
  std::vector<Ribbon> seen;
  std::array<double, kRibbonKinds> drawn_to{};
  for (const Ribbon& ribbon : ribbons) {
    if (ribbon.begin() >= scale.window.last() || ribbon.last_step < scale.window.first()) continue;
    const double end = std::ceil(std::max(scale.x_of(ribbon.begin()) + 1, scale.x_of(ribbon.last_step)));
    double& reached = drawn_to[static_cast<std::size_t>(ribbon.kind)];
    if (end <= reached) continue;
    reached = end;
    seen.push_back(ribbon);
  }
  return seen;
}

}  // namespace kerf
