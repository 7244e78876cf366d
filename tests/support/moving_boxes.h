#pragma once

#include <cstdint>
#include <vector>

#include "core/base/random.h"
#include "core/objects/broad_phase.h"

namespace kerf::test {

/// A crowd of boxes that drives a broad phase through the motions which hurt one. The same seed gives the
/// same requests. Object k of the crowd is object k of the broad phase; ids of removed objects are used
/// again.
template <int D>
class MovingBoxes {
 public:
  /// Boxes live in a cube from 0 to `world`, with half extents up to `reach`.
  MovingBoxes(BroadPhase<D>& broad_phase, double world, double reach, std::uint64_t seed);

  /// Inserts `count` boxes at random places; every `fixed_every`-th is fixed (0: none).
  void add(std::uint32_t count, std::uint32_t fixed_every = 0);
  /// Removes `count` random objects.
  void remove(std::uint32_t count);
  /// Removes and inserts `count` objects in the same step, under the same ids.
  void replace(std::uint32_t count);

  /// Each moving box goes up to `distance` along each axis.
  void walk(double distance);
  /// Each moving box flies on and bounces off the walls of the world.
  void bounce(double time);
  /// Each moving box goes to a random place.
  void teleport();
  /// Each moving box goes the given share of the way to the centre; negative shares drive it away.
  void gather(double share);
  /// Each moving box is scaled about its centre.
  void scale(double factor);
  /// `count` random boxes get a NaN, an infinite bound or min > max until they move again.
  void damage(std::uint32_t count);
  /// Every damaged box that has not moved since gets its valid box again.
  void heal();

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(alive_.size()); }

 private:
  struct Member {
    Vector<D> center;
    Vector<D> half;
    Vector<D> velocity;
    bool fixed = false;
  };

  Member random_member();
  void insert(ObjectId object);
  ObjectId any();
  void send(ObjectId object);
  template <class Change>
  void move_all(Change change);

  BroadPhase<D>& broad_phase_;
  Random random_;
  double world_;
  double reach_;
  std::vector<Member> crowd_;  ///< by id
  std::vector<ObjectId> alive_;
  std::vector<ObjectId> unused_;
  std::vector<ObjectId> damaged_;
};

}  // namespace kerf::test
