#pragma once

// Worlds and boxes of other shapes than cubes, and other densities.

#include <algorithm>
#include <cmath>

#include "frames/bench/motions/scattered.h"

namespace kerf {
/// Straight flight on a plane of the world (in 2D along a line) on which all objects stand: the last axis
/// separates nothing.
template <int D>
class FlatWorld final : public Flight<D> {
 public:
  FlatWorld(std::uint32_t count, std::uint64_t seed) : Flight<D>(count, seed, side_for(count, D - 1)) {
    constexpr double kUneven = 0.2;
    for (std::size_t k = 0; k < count; ++k) {
      this->velocities_[k][D - 1] = 0;
      this->centers_[k][D - 1] = static_cast<Scalar>(this->uniform(0, kUneven));
      this->put(k, this->centers_[k]);
    }
  }
};

/// Straight flight on islands of some 200 objects each, the next one a thousand sizes away along the
/// diagonal.
template <int D>
class Islands final : public Flight<D> {
 public:
  Islands(std::uint32_t count, std::uint64_t seed)
      : Flight<D>(count, seed, side_for(count / number_for(count), D)), islands_(number_for(count)) {
    this->bounds_ = this->cube(this->side_ + kApart * islands_);
    spread();
  }
  void advance() override {
    Flight<D>::advance();
    spread();
  }

 private:
  static constexpr std::uint32_t kOnEach = 200;
  static constexpr double kApart = 1000;

  static std::uint32_t number_for(std::uint32_t count) { return std::max(count / kOnEach, std::uint32_t{1}); }
  void spread() {
    for (std::uint32_t k = 0; k < this->boxes_.size(); ++k)
      this->boxes_[k] =
          this->around(this->centers_[k] + this->along_all(kApart * (k % islands_)), this->halves_[k]);
  }

  std::uint32_t islands_;
};

/// Rods sixty times as long as thick, each along an axis, that fly by most of their thickness in each step.
template <int D>
class Rods final : public Flight<D> {
 public:
  Rods(std::uint32_t count, std::uint64_t seed)
      : Flight<D>(count, seed, side_for(count, D, like_cubes()), kStride * kThickness) {
    for (std::size_t k = 0; k < count; ++k) {
      Vector<D> half = this->along_all(kThickness / 2);
      half[static_cast<int>(k % D)] = static_cast<Scalar>(kLength / 2);
      this->halves_[k] = half;
      this->put(k, this->centers_[k]);
    }
  }

 private:
  /// The extent of cubes with as many pairs: two rods are parallel, or cross.
  static double like_cubes() {
    const double parallel = 2 * kLength * std::pow(2 * kThickness, D - 1);
    const double crossed = std::pow(kLength + kThickness, 2) * std::pow(2 * kThickness, D - 2);
    return std::pow(parallel / D + crossed * (D - 1) / D, 1.0 / D) / 2;
  }

  static constexpr double kLength = 12;
  static constexpr double kThickness = 0.2;
};

}  // namespace kerf
