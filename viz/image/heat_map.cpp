#include <algorithm>
#include <cmath>

#include "viz/image/flip.h"

namespace kerf {
namespace {

struct Shade {
  double r, g, b;
};

/// Seventeen colours of matplotlib's "magma" (van der Walt and Smith, CC0), equally far apart; between them
/// it is nearly straight.
constexpr Shade kMagma[] = {{0, 0, 4},       {10, 8, 34},    {29, 17, 71},   {54, 16, 107},   {81, 18, 124},
                            {106, 28, 129},  {130, 38, 129}, {156, 46, 127}, {182, 55, 121},  {207, 65, 112},
                            {230, 81, 99},   {245, 105, 92}, {251, 135, 97}, {254, 165, 113}, {254, 195, 135},
                            {253, 224, 162}, {252, 253, 191}};
constexpr int kSteps = static_cast<int>(std::size(kMagma)) - 1;

std::uint8_t between(double a, double b, double t) {
  return static_cast<std::uint8_t>(std::lround(a + (b - a) * t));
}

}  // namespace

Image heat_map(const Channel& errors) {
  Image image = make_image(errors.width, errors.height);
  auto out = image.rgba.begin();
  for (const float error : errors.values) {
    const double place = std::clamp(double{error}, 0.0, 1.0) * kSteps;
    const int step = std::min(static_cast<int>(place), kSteps - 1);
    const Shade& a = kMagma[step];
    const Shade& b = kMagma[step + 1];
    const double t = place - step;
    *out++ = between(a.r, b.r, t);
    *out++ = between(a.g, b.g, t);
    *out++ = between(a.b, b.b, t);
    *out++ = 255;
  }
  return image;
}

}  // namespace kerf
