#pragma once

#include <memory>

#include "frames/rivals/query_rival.h"
#include "frames/rivals/rival.h"

namespace kerf {

/// b2DynamicTree, queried for the neighbours of every moving object in each step.
std::unique_ptr<BroadPhase<2>> make_box2d_tree(const RivalHints<2>& hints, Intake intake);
/// b2BroadPhase, which reports new pairs of fat boxes; they are kept as Box2D's contact manager keeps them.
std::unique_ptr<BroadPhase<2>> make_box2d_broad_phase(const RivalHints<2>& hints, Intake intake);
/// btDbvtBroadphase: two dynamic trees of fat boxes and a hashed cache of pairs.
std::unique_ptr<BroadPhase<3>> make_bullet_dbvt(const RivalHints<3>& hints, Intake intake);
/// bt32BitAxisSweep3: three sorted lists of ends, quantised to 32 bits over the bounds.
std::unique_ptr<BroadPhase<3>> make_bullet_axis_sweep(const RivalHints<3>& hints, Intake intake);
/// CGAL::box_self_intersection_d, which builds its segment trees anew each time, with closed boxes.
template <int D>
std::unique_ptr<BroadPhase<D>> make_cgal(const RivalHints<D>& hints, Intake intake);
/// Embree's rtcCollide on one thread: a tree of user primitives, built anew when boxes change. Moving and
/// fixed objects have a scene each.
std::unique_ptr<BroadPhase<3>> make_embree(const RivalHints<3>& hints, Intake intake);
/// The managers of the Flexible Collision Library, which hold the boxes in doubles.
std::unique_ptr<BroadPhase<3>> make_fcl_dynamic_tree(const RivalHints<3>& hints, Intake intake);
std::unique_ptr<BroadPhase<3>> make_fcl_sweep_and_prune(const RivalHints<3>& hints, Intake intake);
std::unique_ptr<BroadPhase<3>> make_fcl_interval_tree(const RivalHints<3>& hints, Intake intake);
std::unique_ptr<BroadPhase<3>> make_fcl_spatial_hash(const RivalHints<3>& hints, Intake intake);
/// ODE's spaces, as in sims3d/.
std::unique_ptr<BroadPhase<3>> make_ode_hash(const RivalHints<3>& hints, Intake intake);
std::unique_ptr<BroadPhase<3>> make_ode_quadtree(const RivalHints<3>& hints, Intake intake);
std::unique_ptr<BroadPhase<3>> make_ode_sweep_and_prune(const RivalHints<3>& hints, Intake intake);

std::unique_ptr<QueryRival<2>> make_box2d_queries();
std::unique_ptr<QueryRival<3>> make_bullet_queries();
std::unique_ptr<QueryRival<3>> make_embree_queries();
std::unique_ptr<QueryRival<3>> make_fcl_queries();

}  // namespace kerf
