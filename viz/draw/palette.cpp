#include "viz/draw/palette.h"

#include <algorithm>
#include <array>

namespace kerf::palette {
namespace {

// viridis at 0.3, 0.4 ... 0.9 (van der Walt and Smith, matplotlib, CC0): its dark end hides black lines, its
// yellow end is lost on a light ground.
constexpr std::array<Color, 7> kViridis{{{53, 95, 141},
                                         {42, 120, 142},
                                         {33, 145, 140},
                                         {34, 168, 132},
                                         {68, 191, 112},
                                         {122, 209, 81},
                                         {189, 223, 38}}};

}  // namespace

Color population_color(std::uint32_t population, std::uint32_t largest) {
  const double t = largest == 0 ? 0.0 : std::min(1.0, static_cast<double>(population) / largest);
  const double position = t * static_cast<double>(kViridis.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(position), kViridis.size() - 2);
  return mix(kViridis[low], kViridis[low + 1], position - static_cast<double>(low));
}

}  // namespace kerf::palette
