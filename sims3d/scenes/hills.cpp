#include "sims3d/scenes/hills.h"

#include <algorithm>
#include <cmath>

namespace kerf {
namespace {

constexpr double kAreaPerBump = 110;
constexpr double kRimWidth = 8;
constexpr double kRimHeight = 9;
constexpr double kShrink = 1 - 0x1p-10;

}  // namespace

Hills::Hills(double half, Random random) : half_(half) {
  const auto count = static_cast<std::size_t>(4 * half * half / kAreaPerBump);
  for (std::size_t i = 0; i < count; ++i) {
    Bump bump{};
    bump.x = random.uniform(-half, half);
    bump.z = random.uniform(-half, half);
    bump.radius = random.uniform(7, 14);
    bump.amplitude = random.uniform(1.5, 4);
    if (random.below(2) == 0) bump.amplitude = -bump.amplitude;
    bumps_.push_back(bump);
  }
}

double Hills::height(double x, double z) const {
  double sum = 0;
  for (const Bump& bump : bumps_) {
    const double dx = x - bump.x;
    const double dz = z - bump.z;
    const double falloff = 1 - (dx * dx + dz * dz) / (bump.radius * bump.radius);
    if (falloff > 0) sum += bump.amplitude * falloff * falloff;
  }
  const double rim = (std::max(std::abs(x), std::abs(z)) - (half_ - kRimWidth)) / kRimWidth;
  if (rim <= 0) return sum;
  return sum * (1 - rim) * (1 - rim) + kRimHeight * rim * rim;
}

Surface Hills::tile(double x, double z, std::uint32_t quads) const {
  Surface surface;
  const double middle = 0.5 * quads;
  for (std::uint32_t k = 0; k <= quads; ++k) {
    for (std::uint32_t i = 0; i <= quads; ++i) {
      const double y = height(x + i, z + k);
      surface.vertices.push_back({{static_cast<Scalar>((i - middle) * kShrink), static_cast<Scalar>(y),
                                   static_cast<Scalar>((k - middle) * kShrink)}});
    }
  }
  const std::uint32_t row = quads + 1;
  for (std::uint32_t k = 0; k < quads; ++k) {
    for (std::uint32_t i = 0; i < quads; ++i) {
      const std::uint32_t corner = k * row + i;
      surface.triangles.push_back({corner, corner + row, corner + 1});
      surface.triangles.push_back({corner + 1, corner + row, corner + row + 1});
    }
  }
  return surface;
}

}  // namespace kerf
