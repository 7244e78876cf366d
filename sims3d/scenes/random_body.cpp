#include "sims3d/scenes/random_body.h"

#include <cmath>

namespace kerf {
namespace {

constexpr double kMinHalf = 0.35;
constexpr double kMaxHalf = 0.55;

}  // namespace

Shape<3> random_shape(Random& random) {
  const bool ball = random.below(2) == 0;
  if (ball) return Ball{static_cast<Scalar>(random.uniform(kMinHalf, kMaxHalf))};
  Brick<3> brick;
  for (int i = 0; i < 3; ++i) brick.half[i] = static_cast<Scalar>(random.uniform(kMinHalf, kMaxHalf));
  return brick;
}

/// A random point of the unit disc, normalised.
std::array<Vector<3>, 3> random_turn(Random& random) {
  while (true) {
    const double c = random.uniform(-1, 1);
    const double s = random.uniform(-1, 1);
    const double norm2 = c * c + s * s;
    if (norm2 > 1 || norm2 < 1e-4) continue;
    const double norm = std::sqrt(norm2);
    const auto cosine = static_cast<Scalar>(c / norm);
    const auto sine = static_cast<Scalar>(s / norm);
    return {Vector<3>{{cosine, 0, -sine}}, Vector<3>{{0, 1, 0}}, Vector<3>{{sine, 0, cosine}}};
  }
}

Vector<3> random_vector(Random& random, double reach) {
  Vector<3> v;
  for (int i = 0; i < 3; ++i) v[i] = static_cast<Scalar>(random.uniform(-reach, reach));
  return v;
}

}  // namespace kerf
