#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/objects/broad_phase.h"
#include "core/scene/move_batch.h"
#include "core/scene/scene.h"
#include "sims3d/narrow_phase.h"
#include "sims3d/ode_library.h"
#include "sims3d/sleep.h"

namespace kerf {

/// Physics of a world; lengths are in units of about one object's size, Y points up.
struct WorldSettings {
  double step_seconds = 0.04;  ///< 25 steps a second (paper section 6.1)
  double gravity = 9.81;       ///< downwards
  double density = 1;
  int iterations = 12;  ///< of ODE's quick-step solver
  double friction = 0.6;
  /// Terminal speed. With what gravity adds before a step moves anything, it makes 0.35 units a step, the
  /// smallest half extent of our scenes' objects, so that no object's middle passes through a surface unseen.
  double max_speed = 8.35;
  SleepRule sleep;
};

/// How an object moves: its velocity and its turning.
struct Twist {
  Vector<3> linear;   ///< units a second
  Vector<3> angular;  ///< radians a second
};

/// An ODE world in which the given broad phase, and no other, proposes the pairs. ODE's spaces are never
/// used.
///
/// One step is one broad phase, one narrow phase and one step of dynamics. The dynamics are not divided
/// further: contacts found at a pose hold for that pose only, and the terminal speed keeps objects from
/// passing through each other. Pairs are sorted before they are used, so that all exact broad phases lead to
/// the same run, bit for bit.
///
/// Use one world from one thread at a time; several worlds may live, and be advanced by several threads, at
/// once.
class OdeWorld {
 public:
  /// Takes an empty broad phase, which must outlive the world. `seed` is the solver's.
  OdeWorld(BroadPhase<3>& broad_phase, std::uint64_t seed, const WorldSettings& settings = {});
  OdeWorld(const OdeWorld&) = delete;
  OdeWorld& operator=(const OdeWorld&) = delete;
  ~OdeWorld();

  /// Adds an object that never moves. It is given to the broad phase once. Throws std::invalid_argument for a
  /// shape that `make_geom` refuses, std::runtime_error if the broad phase refuses the object.
  ObjectId add_fixed(const Shape<3>& shape, const Vector<3>& position);
  /// Adds a ball or brick; throws as `add_fixed` does.
  ObjectId add_moving(const Shape<3>& shape, const Pose<3>& pose, const Twist& motion);

  // The following calls take effect in the next `advance()` and throw std::invalid_argument for anything but
  // a moving object.

  /// Puts an object somewhere else, awake.
  void place(ObjectId object, const Vector<3>& position, const Twist& motion);
  /// Accelerates an object for one step, besides gravity and contacts: units a second squared.
  void push(ObjectId object, const Vector<3>& acceleration);
  /// Gives an object another shape, of the world's density, in the same place and motion; wakes it. Throws as
  /// `add_moving` does.
  void reshape(ObjectId object, const Shape<3>& shape);
  /// Gives an object a terminal speed of its own, in units a second.
  void set_max_speed(ObjectId object, double speed);
  /// How an object moves after the last step of dynamics.
  [[nodiscard]] Twist twist_of(ObjectId object) const;

  /// One step. Throws std::runtime_error if a body's pose or velocity is no longer finite, if the broad phase
  /// refuses a box or names an object that does not exist, or if ODE reports an error; std::bad_alloc if
  /// memory ends.
  void advance();

  [[nodiscard]] std::uint32_t step() const { return step_; }
  /// Object k at the pose that the last broad phase and narrow phase saw; a new object at its given pose.
  [[nodiscard]] std::span<const Body<3>> bodies() const { return bodies_; }
  /// All that the broad phase reported, sorted.
  [[nodiscard]] std::span<const Pair> pairs() const { return pairs_; }
  /// Candidates with at least one contact point, sorted.
  [[nodiscard]] std::span<const Pair> contacts() const { return narrow_phase_.contacts(); }
  /// Moving objects that are awake, that is, that the dynamics moved in the last step.
  [[nodiscard]] std::uint32_t awake() const { return awake_; }
  /// The shapes in ODE, at the poses after the last step of dynamics.
  [[nodiscard]] std::span<const Geom> geoms() const { return geoms_; }

 private:
  ObjectId add(Geom geom, OdeHandle<dxBody> rigid, const Shape<3>& shape, Mobility mobility);
  void update_boxes();
  void sort_pairs();
  void find_contacts();
  void wake();
  void wake_hit(const Touch& touch);
  void join();
  void join(const Touch& touch);
  void integrate();
  void check_and_limit(ObjectId object, dBodyID body) const;
  [[nodiscard]] dBodyID moving_body(ObjectId object) const;
  [[nodiscard]] bool is_asleep(ObjectId object) const;
  [[nodiscard]] bool is_awake(ObjectId object) const;

  OdeLibrary library_;  // first: everything below ends before it does
  BroadPhase<3>& broad_phase_;
  WorldSettings settings_;
  OdeHandle<dxWorld> world_;
  OdeHandle<dxJointGroup> joints_;
  std::vector<Body<3>> bodies_;
  std::vector<OdeHandle<dxBody>> rigid_;  // null for fixed objects
  std::vector<Geom> geoms_;
  std::vector<std::uint8_t> moved_;  // since the last narrow phase
  std::vector<double> max_speeds_;
  MoveBatch<3> moves_;
  std::vector<Pair> pairs_;       // sorted
  std::vector<Pair> candidates_;  // of them, each once, those with an object that can move
  NarrowPhase narrow_phase_;
  Sleep sleep_;
  unsigned long solver_seed_;
  std::uint32_t step_ = 0;
  std::uint32_t awake_ = 0;
};

}  // namespace kerf
