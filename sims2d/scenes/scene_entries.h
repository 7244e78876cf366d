#pragma once

#include "core/scene/scene.h"

namespace kerf::inline sims2d {

// Each entry is made in the source of its name.

/// The paper's simulation 2 in 2D: clouds of objects follow several moving attractors, without gravity, and
/// pass through each other. All objects are there from the first step; none ever rests.
SceneEntry<2> attractors_entry();

/// Objects fall into a row of buckets with slanted walls. Objects that miss them or spill over stay in the
/// yard.
SceneEntry<2> buckets_entry();

/// The paper's simulation 3 in 2D: building blocks are pulled by one attractor. A block breaks at its first
/// hit into 16 smaller blocks and becomes the first of them.
SceneEntry<2> fracture_entry();

/// Discs, rectangles and polygons fall into a heap between two walls, past two slanted boards.
SceneEntry<2> pile_entry();

/// A standing pyramid of equal blocks, and a disc that falls onto its top: the stack by which solvers are
/// judged. Boxes touch everywhere and hardly move.
SceneEntry<2> pyramid_entry();

/// Long thin rods come to rest on a slope of 45 degrees that ends at another one. Along the axes their boxes
/// are large and overlap many others; oriented boxes and partitioners in free directions separate them.
SceneEntry<2> rods_entry();

/// The paper's simulation 1 in 2D: discs, rectangles and polygons fall onto hills made of many fixed columns.
/// Their number grows.
SceneEntry<2> terrain_entry();

/// A square drum turns and tumbles its contents. Its four walls are moving objects as long as the scene is
/// wide, at an angle most of the time.
SceneEntry<2> tumbler_entry();

}  // namespace kerf::inline sims2d
