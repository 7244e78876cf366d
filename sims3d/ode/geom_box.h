#pragma once

#include <ode/collision.h>

#include <array>
#include <cstddef>

#include "core/geometry/box.h"

namespace kerf {

/// The geom's box at its present pose, rounded outward so that no contact falls between double and float.
inline Box<3> outward_box(dGeomID geom) {
  std::array<dReal, 6> bounds{};
  dGeomGetAABB(geom, bounds.data());
  Box<3> box;
  for (int i = 0; i < 3; ++i) {
    box.min[i] = round_down(bounds[2 * static_cast<std::size_t>(i)]);
    box.max[i] = round_up(bounds[2 * static_cast<std::size_t>(i) + 1]);
  }
  return box;
}

}  // namespace kerf
