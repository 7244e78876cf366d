#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "sims3d/ode_library.h"

namespace kerf {

/// A geom's box as ODE has it: min and max of x, y and z; and whether it moves.
struct OdeBox {
  std::array<dReal, 6> bounds;
  bool fixed = false;
};

// How many pairs of boxes a space of ODE compares in one dSpaceCollide(): its candidates.
//
// ODE's callback cannot count them: collideAABBs() (ODE 0.16, collision_space_internal.h) tests category
// bits, then compares the boxes, and calls back only for boxes that overlap; a geom class' aabb_test comes
// later, too. So a second space gets geoms of a class of our own, whose boxes we can reach: ODE passes the
// place of the geom's box to the class. It builds its structure from the true boxes; then the boxes become
// NaN, no comparison with which says "apart", so that ODE calls back for each pair that it compares. Pairs of
// two fixed objects are not among them: category bits exclude them before a comparison.

/// Of a dHashSpace; negative if it cannot be counted, since the boxes reach farther than 1e8. `space` is
/// empty, and is left with nothing in it.
double count_hash_candidates(dSpaceID space, std::span<const OdeBox> boxes);
/// Of a dQuadTreeSpace.
double count_quadtree_candidates(dSpaceID space, std::span<const OdeBox> boxes);
/// Of a dSweepAndPruneSpace whose first axis is X: the pairs that overlap along it. It compares pairs of two
/// fixed objects, too.
double count_sweep_candidates(dSpaceID space, std::span<const OdeBox> boxes);

}  // namespace kerf
