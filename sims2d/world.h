#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/objects/broad_phase.h"
#include "core/scene/move_batch.h"
#include "core/scene/scene.h"
#include "core/scene/shape.h"

class b2Body;
class b2World;

namespace kerf {
class Box2dContacts;
}

namespace kerf::inline sims2d {

/// A 2D body at its beginning.
struct BodyPlan {
  Shape<2> shape;
  Vector<2> position;
  Scalar angle = 0;
  Mobility mobility = Mobility::moving;
  Vector<2> velocity;
  Scalar spin = 0;      ///< radians a second
  bool driven = false;  ///< moves as `place` says and nothing stops it: the wall of a machine
};

/// A Box2D world with contacts from a broad phase of ours and from nothing else. Units are metres and
/// seconds, Y is up; body k is object k of the broad phase.
///
/// Each step runs the broad phase once, with the boxes of the poses at which Box2D's narrow phase then looks,
/// and makes the contacts exactly those pairs (`Box2dContacts`). A pair that is not reported has no contact
/// even if it had one before, so that a miss shows. Boxes are the tight ones plus `kBoxPadding`
/// (box2d/padded_box.h), and not Box2D's fat ones, which run up to 0.5 units and four steps of motion ahead:
/// everything that touches overlaps, the drawing shows what was tested, and contacts are a function of the
/// poses alone. Box2D's own broad phase finds the same touching contacts from the same state.
///
/// The step is 1/25 s, not divided. Continuous collision is off, because it would look at pairs between two
/// queries. Instead nothing is fast: drag limits a fall to `kFallSpeed`, 0.32 units a step, less than half
/// the smallest object of our scenes and far below Box2D's limit of 2.
///
/// The solver's result depends on the order of contacts, so pairs are sorted before they become contacts:
/// broad phases that agree on the pairs give bit-identical trajectories.
class Box2dWorld {
 public:
  static constexpr Scalar kStepSeconds = 1.0F / 25.0F;
  static constexpr Scalar kGravity = 10.0F;
  static constexpr Scalar kDrag = 1.25F;                  ///< loss of speed, per second
  static constexpr Scalar kFallSpeed = kGravity / kDrag;  ///< at which drag and gravity are equal

  /// `broad_phase` must hold no objects and outlive the world. `gravity` pulls down.
  explicit Box2dWorld(BroadPhase<2>& broad_phase, Scalar gravity = kGravity);
  ~Box2dWorld();
  Box2dWorld(const Box2dWorld&) = delete;
  Box2dWorld& operator=(const Box2dWorld&) = delete;

  /// Adds a body and its box. Throws std::invalid_argument for an invalid shape or pose, and
  /// std::runtime_error if the broad phase refuses the object.
  ObjectId add(const BodyPlan& plan);

  /// Gives a moving body the pose and motion of the plan and wakes it; its shape stays. Takes effect in the
  /// next `advance()`. Throws std::invalid_argument as `add` does, and for a fixed or unknown body.
  void place(ObjectId object, const BodyPlan& plan);
  /// Accelerates a moving body for the next step, besides gravity and contacts, and keeps it awake: metres a
  /// second squared. Throws std::invalid_argument for a fixed or unknown body.
  void push(ObjectId object, const Vector<2>& acceleration);
  /// Gives a moving body another shape in the same place and motion, awake. Throws as `add` and `push` do.
  void reshape(ObjectId object, const Shape<2>& shape);
  /// Units a second after the last step. Throws as `push` does.
  [[nodiscard]] Vector<2> velocity_of(ObjectId object) const;
  /// Radians a second after the last step. Throws as `push` does.
  [[nodiscard]] Scalar spin_of(ObjectId object) const;

  /// One step. Fixed and sleeping bodies are not moved in the broad phase. Throws std::runtime_error for a
  /// pose that is not finite and for pairs of unknown objects.
  void advance();

  [[nodiscard]] std::uint32_t step() const { return step_; }
  [[nodiscard]] std::span<const Body<2>> bodies() const { return bodies_; }
  /// All that the broad phase reported, sorted.
  [[nodiscard]] std::span<const Pair> pairs() const { return pairs_; }
  [[nodiscard]] std::span<const Pair> contacts() const { return contacts_; }
  /// Box2D's world, to read.
  [[nodiscard]] const b2World& engine() const { return *engine_; }

 private:
  [[nodiscard]] b2Body& moving_body(ObjectId object) const;
  void update_boxes();
  void ask();
  void collect_contacts();

  BroadPhase<2>& broad_phase_;
  std::unique_ptr<b2World> engine_;
  std::unique_ptr<Box2dContacts> admitted_;
  std::vector<b2Body*> handles_;
  std::vector<Body<2>> bodies_;
  std::vector<std::uint8_t> reshaped_;  ///< since the last step
  MoveBatch<2> moves_;
  std::vector<Pair> pairs_;  ///< sorted
  std::vector<Pair> contacts_;
  std::uint32_t step_ = 0;
};

}  // namespace kerf::inline sims2d
