#pragma once

#include <vector>

#include "core/scene/scene.h"

namespace kerf::test {

/// Points of the rim of a body, in the world: the corners, or 64 points of the circle.
std::vector<Vector<2>> rim(const Body<2>& body);

/// A square standing on a corner, its corners 0.5 from its middle.
Shape<2> diamond();

}  // namespace kerf::test
