#pragma once

#include "core/scene/scene.h"

namespace kerf {

// Each entry is made in the source of its name.

/// The paper's simulation 2 (section 6.2): a chaotic scene without ground in which clouds of objects follow
/// several moving attractors, pass through each other and collide. All objects are there from the first step;
/// none ever rests.
SceneEntry<3> attractors_entry();

/// The paper's simulation 4 (section 6.2): balls and bricks fall into open buckets, which stand in a square
/// on the XZ plane, and pile up there. There are enough buckets for piles about three units deep. Each bucket
/// is a floor tile and four walls, all separate bricks that never move; a low fence closes the square.
SceneEntry<3> buckets_entry();

/// The same without sleep: the cost of a broad phase when piles never come to rest.
SceneEntry<3> awake_buckets_entry();

/// The paper's simulation 3 (section 6.2): a few building blocks are pulled by one attractor. A block breaks
/// at its first hit into 27 smaller blocks and becomes the first of them, so that no object ever goes.
SceneEntry<3> fracture_entry();

/// Soft blocks tumble into a basin: the paper's announced extension to deformable objects (section 7). Each
/// block breathes, and wobbles after every knock: its extents follow damped springs while its volume stays,
/// so that every box changes its size in every step.
SceneEntry<3> jelly_entry();

/// A heavy ball is shot through a stack of blocks at rest, 1.8 units a step; every 100 steps it comes anew,
/// from the other side. One box that jumps by more than its neighbours' size, and bursts of motion in a scene
/// at rest.
SceneEntry<3> projectile_entry();

/// Long thin rods, nearly parallel to a diagonal of the floor, fall onto it in layers and come to rest as a
/// bed of logs. Along the axes their boxes are large and overlap many others; oriented boxes and partitioners
/// in free directions separate them.
SceneEntry<3> rods_entry();

/// The paper's simulation 1 (section 6.2): spheres and blocks fall into a terrain; their number grows. The
/// terrain is a square of at least 16 by 16 tiles, each a mesh and an object of its own that never moves; a
/// rim keeps everything inside. Its area grows with the number of objects.
SceneEntry<3> terrain_entry();

}  // namespace kerf
