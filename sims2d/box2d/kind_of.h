#pragma once

#include <box2d/b2_body.h>

#include "core/world/world.h"

namespace kerf {

inline ObjectKind kind_of(b2BodyType type) {
  if (type == b2_dynamicBody) return ObjectKind::moving;
  return type == b2_kinematicBody ? ObjectKind::kinematic : ObjectKind::fixed;
}

/// Whether Box2D looks at the body's shapes in each step: then they may be changed in place.
inline bool is_refreshed(const b2Body& body) { return body.IsAwake() && body.GetType() != b2_staticBody; }

}  // namespace kerf
