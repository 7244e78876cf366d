#pragma once

#include <cstdint>
#include <vector>

#include "core/base/random.h"
#include "tests/hard/cases.h"

namespace kerf::test {

/// Boxes with a few neighbours each that walk about: the healthy part of many cases. Object k of the crowd is
/// object `first + k` of the script.
template <int D>
class Crowd {
 public:
  /// `reach`: largest half extent. The world is as large as gives each box a few neighbours.
  Crowd(ScriptWriter<D>& out, std::uint32_t count, std::uint64_t seed, double reach = 1.5,
        std::uint32_t first = 0);

  /// Inserts all; every `fixed_every`-th is fixed (0: none).
  void insert(std::uint32_t fixed_every = 0);
  /// Moves each that is not fixed up to `distance` along each axis.
  void walk(double distance);
  /// Moves each that is not fixed to a random place.
  void teleport();
  /// Each goes the given share of the way to the world's centre; negative shares drive it away.
  void gather(double share);
  void scale(double factor);
  /// Adds `offset` to every axis of what is written from now on.
  void set_offset(double offset) { offset_ = offset; }

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(members_.size()); }
  [[nodiscard]] double world() const { return world_; }
  [[nodiscard]] Box<D> box(std::uint32_t k) const;
  /// Requests the present box of member k.
  void send(std::uint32_t k);
  Random& random() { return random_; }

 private:
  struct Member {
    Vector<D> center;
    Vector<D> half;
    bool fixed = false;
  };
  template <class Change>
  void move_all(Change change);

  ScriptWriter<D>& out_;
  Random random_;
  double world_;
  std::uint32_t first_;
  double offset_ = 0;
  std::vector<Member> members_;
};

/// The smallest side of a lattice of D dimensions with at least `count` cells.
template <int D>
std::uint32_t lattice_side(std::uint32_t count) {
  std::uint32_t side = 1;
  while (D == 2 ? side * side < count : side * side * side < count) ++side;
  return side;
}

/// Cell k of a lattice of that side, counted along the first axis first.
template <int D>
Vector<D> lattice_cell(std::uint32_t k, std::uint32_t side) {
  Vector<D> cell;
  for (int axis = 0; axis < D; ++axis) {
    cell[axis] = static_cast<Scalar>(k % side);
    k /= side;
  }
  return cell;
}

constexpr std::uint32_t pick(Size size, std::uint32_t test, std::uint32_t report) {
  return size == Size::test ? test : report;
}

}  // namespace kerf::test
