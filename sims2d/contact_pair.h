#pragma once

#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>

#include "core/base/ids.h"

namespace kerf::inline sims2d {

/// The object that a body of a `Box2dWorld` stands for.
inline ObjectId object_of(b2Body& body) {
  return ObjectId{static_cast<std::uint32_t>(body.GetUserData().pointer)};
}

inline Pair pair_of(b2Contact& contact) {
  return make_pair(object_of(*contact.GetFixtureA()->GetBody()),
                   object_of(*contact.GetFixtureB()->GetBody()));
}

}  // namespace kerf::inline sims2d
