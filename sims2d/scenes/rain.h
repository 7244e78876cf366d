#pragma once

#include <cstdint>
#include <vector>

#include "core/base/random.h"
#include "core/scene/shape.h"
#include "core/scene/world_scene.h"
#include "sims2d/scenes/growth.h"
#include "sims2d/world.h"

namespace kerf::inline sims2d {

/// Where objects come from: a level line from `left` to `right` at height `bottom`.
struct Band {
  Scalar left = 0;
  Scalar right = 0;
  Scalar bottom = 0;
};

/// A disc, a rectangle or a convex polygon, 0.7 to 1.3 units across.
Shape<2> random_shape(Random& random);

/// Drops random objects from a band, as they are due, without ever placing one on another.
///
/// Objects stand in slots of a row, in random order, and fall at `Box2dWorld::kFallSpeed` from the start, so
/// that the progress of each row is known. When a row is full or has left the band, the next one begins above
/// it; if more objects are due than the band is wide, rows pile up upwards, and every object comes in time.
class Rain {
 public:
  /// The band must be at least one slot (`kSlot`) wide.
  Rain(const Band& band, const Growth& growth, std::uint64_t seed);

  static constexpr Scalar kSlot = 1.7F;

  /// Adds the objects that are due in step `step` (counted from 1) to `world`, and lets old objects fall
  /// again. Call it once a step, just before the world's own.
  void fall(Box2dWorld& world, std::uint32_t step);

 private:
  void recycle(Box2dWorld& world, std::uint32_t step);
  void begin_row();
  BodyPlan next();

  Band band_;
  Growth growth_;
  Random random_;
  std::uint32_t fallen_ = 0;
  std::vector<ObjectId> objects_;     ///< in the order in which they fell
  std::size_t recycled_ = 0;          ///< so far; objects take turns
  Scalar row_height_ = 0;             ///< of the row being filled, now
  std::vector<std::uint32_t> slots_;  ///< those still free in this row; the last is next
};

/// The difference between two of these scenes: the fixed bodies and the rain of objects onto them.
struct RainPlan {
  Needs needs;
  std::vector<BodyPlan> fixed;
  Band band;
  Growth growth;
};

/// A scene in which more and more objects fall onto fixed bodies. The fixed bodies are the first objects.
class RainScene final : public WorldScene<2, Box2dWorld> {
 public:
  RainScene(BroadPhase<2>& broad_phase, const RainPlan& plan, std::uint64_t seed);

 private:
  void act() override { rain_.fall(world(), step() + 1); }

  Rain rain_;
};

}  // namespace kerf::inline sims2d
