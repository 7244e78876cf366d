#pragma once

#include <cmath>
#include <cstdint>

#include "core/base/random.h"
#include "core/geometry/box.h"
#include "core/geometry/vector.h"

namespace kerf {

/// A point that attracts objects, and repels them within its calm radius, so that a cloud forms around it and
/// not a lump.
template <int D>
struct Attractor {
  Vector<D> position;
  Vector<D> velocity;      ///< units a second
  Scalar strength = 10;    ///< greatest acceleration, units a second squared
  Scalar calm_radius = 1;  ///< distance at which nothing is drawn or pushed; greater than 0

  /// The acceleration of an object at `place` that keeps `nearness` calm radii away.
  [[nodiscard]] Vector<D> pull(const Vector<D>& place, Scalar nearness = 1) const {
    const Vector<D> way = position - place;
    const Scalar distance = length(way);
    if (distance == 0) return {};
    const Scalar excess = distance / (calm_radius * nearness) - 1;
    return way * (strength * std::fmin(std::fmax(excess, Scalar{-1}), Scalar{1}) / distance);
  }

  /// Moves on for `seconds`; at the sides of `room` it turns back.
  void advance(Scalar seconds, const Box<D>& room) {
    for (int i = 0; i < D; ++i) {
      position[i] += velocity[i] * seconds;
      if (position[i] < room.min[i]) velocity[i] = std::abs(velocity[i]);
      if (position[i] > room.max[i]) velocity[i] = -std::abs(velocity[i]);
    }
  }
};

/// The distance that an object in a cloud keeps: between 0.3 and 1.7 calm radii, spread evenly over the ids
/// (multiples of the golden ratio), so that a cloud is not a shell.
inline Scalar nearness(std::uint32_t object) {
  constexpr double kGolden = 0.6180339887498949;
  const double turns = kGolden * object;
  return static_cast<Scalar>(0.3 + 1.4 * (turns - std::floor(turns)));
}

/// An attractor somewhere in `room` that moves in a random direction, as fast along each axis.
template <int D>
Attractor<D> random_attractor(Random& random, const Box<D>& room, Scalar speed) {
  Attractor<D> attractor;
  for (int i = 0; i < D; ++i) {
    attractor.position[i] = static_cast<Scalar>(random.uniform(room.min[i], room.max[i]));
    attractor.velocity[i] = random.below(2) == 0 ? speed : -speed;
  }
  return attractor;
}

}  // namespace kerf
