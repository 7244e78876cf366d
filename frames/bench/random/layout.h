#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/random.h"
#include "core/geometry/box.h"
#include "frames/bench/random/random_scene.h"

namespace kerf {

/// A place in a world, in doubles, so that motions do not add up rounding.
template <int D>
using Place = std::array<double, D>;

/// The boxes of a random scene at its beginning.
template <int D>
struct LaidOut {
  std::vector<Place<D>> centers;
  std::vector<Place<D>> halves;
  double side =
      1;  ///< the world is a cube from 0 to `side`; slanted layouts and clusters reach a little beyond
  double size = 1;  ///< the median of the mean extents
};

/// So many boxes: forms and places by the scene, and the side such that the first `scene.objects` have its
/// density, as nearly as their number allows (`kDensityTolerance`, or the nearest pair).
template <int D>
LaidOut<D> lay_out(const RandomScene& scene, std::uint32_t count, Random& random);

inline constexpr double kDensityTolerance = 0.05;

template <int D>
Box<D> box_at(const Place<D>& center, const Place<D>& half) {
  Box<D> box;
  for (int i = 0; i < D; ++i) {
    const auto axis = static_cast<std::size_t>(i);
    box.min[i] = static_cast<Scalar>(center[axis] - half[axis]);
    box.max[i] = static_cast<Scalar>(center[axis] + half[axis]);
  }
  return box;
}

}  // namespace kerf
