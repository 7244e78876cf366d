#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/base/random.h"
#include "core/geometry/box.h"

namespace kerf {

/// Pairs an object in the dense scenes, where placing is uniform: n boxes of mean extent 1 in a cube of
/// volume V have n * 2^(D-1) / V pairs an object.
inline constexpr double kPairsPerObject = 3.7;

/// The side of the cube in which `count` boxes of mean extent `size` have `pairs` pairs an object.
double side_for(std::uint32_t count, int dimension, double size = 1, double pairs = kPairsPerObject);

/// Stands in place of the box of an object that is absent.
template <int D>
constexpr Box<D> no_box() {
  return Box<D>::empty();
}

template <int D>
constexpr bool is_absent(const Box<D>& box) {
  return box.min[0] > box.max[0];
}

/// Boxes that move by a rule of their own, without an engine and independent of any broad phase. The same
/// seed gives the same motion. Objects are numbered from 0; the fixed ones, if any, come last.
template <int D>
class Motion {
 public:
  static constexpr int kDimension = D;
  explicit Motion(std::uint64_t seed) : random_(seed) {}
  Motion(const Motion&) = delete;
  Motion& operator=(const Motion&) = delete;
  virtual ~Motion() = default;

  /// Moves everything by one step.
  virtual void advance() = 0;
  /// By object; `no_box()` for those that are absent.
  [[nodiscard]] std::span<const Box<D>> boxes() const { return boxes_; }
  /// Objects below this number are moving, the others are fixed.
  [[nodiscard]] std::uint32_t moving() const { return moving_; }
  /// Whether `advance` changes every moving object; else `moved` returns which.
  [[nodiscard]] bool all_move() const { return all_move_; }
  [[nodiscard]] std::span<const ObjectId> moved() const { return moved_; }
  /// Which objects came and which went in the last step; they are not among the moved. An object may go and
  /// come in one step.
  [[nodiscard]] std::span<const ObjectId> inserted() const { return inserted_; }
  [[nodiscard]] std::span<const ObjectId> removed() const { return removed_; }
  /// So many objects come and go in a step at most; 0 if `all_move`.
  [[nodiscard]] std::uint32_t most_changes() const { return most_changes_; }
  /// Bounds of the objects and their usual size, for libraries that need them.
  [[nodiscard]] const Box<D>& bounds() const { return bounds_; }
  [[nodiscard]] Scalar box_size() const { return box_size_; }

 protected:
  [[nodiscard]] double uniform(double low, double high) { return random_.uniform(low, high); }
  [[nodiscard]] Vector<D> vector_within(double low, double high) {
    Vector<D> v;
    for (int i = 0; i < D; ++i) v[i] = static_cast<Scalar>(random_.uniform(low, high));
    return v;
  }
  /// Uniform over all directions.
  [[nodiscard]] Vector<D> direction();
  /// Half the extents of a usual box: 0.5 to 1.5 along each axis.
  [[nodiscard]] Vector<D> usual_half() { return vector_within(0.25, 0.75); }
  static Box<D> around(const Vector<D>& center, const Vector<D>& half) {
    return {center - half, center + half};
  }
  static Box<D> cube(double side) { return {{}, along_all(side)}; }
  static Vector<D> along_all(double x) {
    Vector<D> v;
    for (int i = 0; i < D; ++i) v[i] = static_cast<Scalar>(x);
    return v;
  }

  Random random_;
  std::vector<Box<D>> boxes_;
  std::vector<ObjectId> moved_;
  std::vector<ObjectId> inserted_;
  std::vector<ObjectId> removed_;
  Box<D> bounds_{};
  Scalar box_size_ = 1;
  std::uint32_t moving_ = 0;
  std::uint32_t most_changes_ = 0;
  bool all_move_ = true;
};

}  // namespace kerf
