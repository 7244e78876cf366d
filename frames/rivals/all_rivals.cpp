// The libraries that this program is built with (KERF_RIVALS); without them no_rivals.cpp stands in its
// place.

#include <array>

#include "frames/rivals/flat.h"
#include "frames/rivals/makers.h"

namespace kerf {
namespace {

constexpr std::array<Rival<3>, 11> kRivals3{
    {{"bullet-dbvt", "Bullet btDbvtBroadphase", false, make_bullet_dbvt},
     {"bullet-axis-sweep", "Bullet bt32BitAxisSweep3", false, make_bullet_axis_sweep},
     {"fcl-dynamic-tree", "FCL DynamicAABBTreeCollisionManager", false, make_fcl_dynamic_tree},
     {"fcl-sap", "FCL SaPCollisionManager", false, make_fcl_sweep_and_prune},
     {"fcl-interval-tree", "FCL IntervalTreeCollisionManager", false, make_fcl_interval_tree},
     {"fcl-spatial-hash", "FCL SpatialHashingCollisionManager", false, make_fcl_spatial_hash},
     {"cgal-box-intersection", "CGAL box_intersection_d", false, make_cgal<3>},
     {"embree-collide", "Embree rtcCollide", false, make_embree},
     {"ode-hash", "ODE dHashSpace", false, make_ode_hash},
     {"ode-quadtree", "ODE dQuadTreeSpace", false, make_ode_quadtree},
     {"ode-sap", "ODE dSweepAndPruneSpace", false, make_ode_sweep_and_prune}}};

constexpr std::array<Rival<2>, 13> kRivals2{
    {{"box2d-tree", "Box2D b2DynamicTree", false, make_box2d_tree},
     {"box2d-broad-phase", "Box2D b2BroadPhase", false, make_box2d_broad_phase},
     {"cgal-box-intersection", "CGAL box_intersection_d", false, make_cgal<2>},
     {"bullet-dbvt", "Bullet btDbvtBroadphase", true, make_flat<make_bullet_dbvt>},
     {"bullet-axis-sweep", "Bullet bt32BitAxisSweep3", true, make_flat<make_bullet_axis_sweep>},
     {"fcl-dynamic-tree", "FCL DynamicAABBTreeCollisionManager", true, make_flat<make_fcl_dynamic_tree>},
     {"fcl-sap", "FCL SaPCollisionManager", true, make_flat<make_fcl_sweep_and_prune>},
     {"fcl-interval-tree", "FCL IntervalTreeCollisionManager", true, make_flat<make_fcl_interval_tree>},
     {"fcl-spatial-hash", "FCL SpatialHashingCollisionManager", true, make_flat<make_fcl_spatial_hash>},
     {"embree-collide", "Embree rtcCollide", true, make_flat<make_embree>},
     {"ode-hash", "ODE dHashSpace", true, make_flat<make_ode_hash>},
     {"ode-quadtree", "ODE dQuadTreeSpace", true, make_flat<make_ode_quadtree>},
     {"ode-sap", "ODE dSweepAndPruneSpace", true, make_flat<make_ode_sweep_and_prune>}}};

}  // namespace

template <>
std::span<const Rival<2>> rivals<2>() {
  return kRivals2;
}

template <>
std::span<const Rival<3>> rivals<3>() {
  return kRivals3;
}

}  // namespace kerf
