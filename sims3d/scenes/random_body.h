#pragma once

#include <array>

#include "core/base/random.h"
#include "core/scene/shape.h"
#include "sims3d/world.h"

namespace kerf {

/// A ball or a brick, 0.7 to 1.1 units across.
Shape<3> random_shape(Random& random);
/// Axes turned about Y by a random angle, without a library's sine.
std::array<Vector<3>, 3> random_turn(Random& random);
/// A vector with random parts from -reach to reach.
Vector<3> random_vector(Random& random, double reach);

}  // namespace kerf
