#include "sims3d/scenes/yard.h"

#include <algorithm>
#include <cmath>

namespace kerf {
namespace {

constexpr Scalar kTile = 6;
constexpr Scalar kHalfThickness = 0.5F;
constexpr Scalar kHair = 0x1p-10F;  // gap between tiles: where boxes touch, no plane fits between

void add_panels(OdeWorld& world, Scalar along, Scalar half_tile, Scalar offset, Scalar height) {
  const Scalar y = height / 2;
  for (const Scalar side : {-offset, offset}) {
    world.add_fixed(Brick<3>{{{kHalfThickness, y, half_tile}}}, {{side, y, along}});
    world.add_fixed(Brick<3>{{{half_tile, y, kHalfThickness}}}, {{along, y, side}});
  }
}

}  // namespace

void add_yard(OdeWorld& world, Scalar half, Scalar fence_height) {
  const int tiles = std::max(1, static_cast<int>(std::ceil(2 * half / kTile)));
  const Scalar pitch = 2 * half / static_cast<Scalar>(tiles);
  const Scalar half_tile = pitch / 2 - kHair;
  const auto middle = [&](int i) { return (static_cast<Scalar>(i) + 0.5F) * pitch - half; };
  for (int i = 0; i < tiles; ++i) {
    for (int k = 0; k < tiles; ++k)
      world.add_fixed(Brick<3>{{{half_tile, kHalfThickness, half_tile}}},
                      {{middle(i), -kHalfThickness, middle(k)}});
    if (fence_height > 0) add_panels(world, middle(i), half_tile, half + kHalfThickness, fence_height);
  }
}

}  // namespace kerf
