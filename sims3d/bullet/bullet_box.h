#pragma once

#include <BulletCollision/BroadphaseCollision/btBroadphaseInterface.h>
#include <LinearMath/btVector3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "core/base/float_mode.h"
#include "core/geometry/box.h"
#include "core/spatial/lazy_index.h"
#include "core/spatial/query.h"
#include "core/world/world_boxes.h"

namespace kerf {

/// Bullet's boxes may be of doubles; then they are rounded outward.
inline Box<3> to_box(const btVector3& min, const btVector3& max) {
  Box<3> box;
  for (int i = 0; i < 3; ++i) {
    if constexpr (std::is_same_v<btScalar, Scalar>) {
      box.min[i] = min[i];
      box.max[i] = max[i];
    } else {
      box.min[i] = round_down(min[i]);
      box.max[i] = round_up(max[i]);
    }
  }
  return box;
}

/// As World decides: it has no NaN, and min <= max.
inline bool can_be_placed(const Box<3>& box) {
  const UsualComparisons comparisons;
  return is_ordered(box);
}

/// [min, max], around `from`, on the way of the callback, and a little more.
inline Cast<3> to_cast(const btVector3& from, const btBroadphaseRayCallback& callback, const btVector3& min,
                       const btVector3& max) {
  const auto to_scalar = [](btScalar x) {
    constexpr Scalar kMost = std::numeric_limits<Scalar>::max();
    return std::abs(x) <= btScalar{kMost} ? static_cast<Scalar>(x) : std::numeric_limits<Scalar>::infinity();
  };
  SweptBox<3> swept{to_box(from + min, from + max), {}};
  Scalar reach = 0;  // of what btRayAabb2 adds up
  for (int i = 0; i < 3; ++i) {
    swept.displacement[i] = to_scalar(callback.m_lambda_max / callback.m_rayDirectionInverse[i]);
    reach = std::max(reach, to_scalar(std::abs(from[i]) + std::abs(min[i]) + std::abs(max[i])));
  }
  return with_slack(swept, reach);
}

}  // namespace kerf
