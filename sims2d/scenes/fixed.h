#pragma once

#include <vector>

#include "sims2d/world.h"

namespace kerf::inline sims2d {

/// A rectangle that never moves: its centre, half extents and angle.
inline BodyPlan fixed_brick(const Vector<2>& center, const Vector<2>& half, Scalar angle = 0) {
  BodyPlan plan;
  plan.shape = Brick<2>{half};
  plan.position = center;
  plan.angle = angle;
  plan.mobility = Mobility::fixed;
  return plan;
}

/// The two walls and the ground of a yard: its inside reaches from -half_width to half_width and from 0 to
/// `height`.
inline std::vector<BodyPlan> yard(Scalar half_width, Scalar height) {
  constexpr Scalar kThick = 1.0F;
  const Scalar side = half_width + kThick / 2;
  return {fixed_brick({{0, -kThick / 2}}, {{half_width + kThick, kThick / 2}}),
          fixed_brick({{-side, height / 2}}, {{kThick / 2, height / 2}}),
          fixed_brick({{side, height / 2}}, {{kThick / 2, height / 2}})};
}

}  // namespace kerf::inline sims2d
