#pragma once

#include <box2d/b2_body.h>
#include <box2d/b2_common.h>
#include <box2d/b2_math.h>

#include <algorithm>

namespace kerf {

/// Where a body's present velocities take and turn it in `seconds`.
/// Box2D turns no body further than b2_maxRotation in a step.
inline b2Transform pose_after(const b2Body& body, float seconds) {
  const b2Vec2 way = seconds * body.GetLinearVelocity();
  const float turn = std::clamp(seconds * body.GetAngularVelocity(), -b2_maxRotation, b2_maxRotation);
  b2Transform pose = body.GetTransform();
  if (turn == 0) {
    pose.p += way;
    return pose;
  }
  pose.q.Set(body.GetAngle() + turn);
  pose.p = body.GetWorldCenter() + way - b2Mul(pose.q, body.GetLocalCenter());
  return pose;
}

inline bool is_same_pose(const b2Transform& a, const b2Transform& b) {
  return a.p == b.p && a.q.s == b.q.s && a.q.c == b.q.c;
}

}  // namespace kerf
