#pragma once

#include <box2d/b2_body.h>

#include "core/world/world.h"

namespace kerf {

inline ObjectKind kind_of(b2BodyType type) {
  if (type == b2_dynamicBody) return ObjectKind::moving;
  return type == b2_kinematicBody ? ObjectKind::kinematic : ObjectKind::fixed;
}

}  // namespace kerf
