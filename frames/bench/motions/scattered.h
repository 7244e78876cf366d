#pragma once

#include <cstdint>
#include <vector>

#include "frames/bench/motion.h"

namespace kerf {

/// The distance that most of these objects move in each step, in usual extents.
inline constexpr double kStride = 0.75;

/// Boxes scattered evenly in a cube.
template <int D>
class Scattered : public Motion<D> {
 public:
  Scattered(std::uint32_t count, std::uint64_t seed, double side) : Motion<D>(seed), side_(side) {
    this->moving_ = count;
    this->bounds_ = this->cube(side_);
    for (std::uint32_t k = 0; k < count; ++k) {
      centers_.push_back(this->vector_within(0, side_));
      halves_.push_back(this->usual_half());
      this->boxes_.push_back(this->around(centers_[k], halves_[k]));
    }
  }

 protected:
  void put(std::size_t k, const Vector<D>& center) {
    centers_[k] = center;
    this->boxes_[k] = this->around(center, halves_[k]);
  }
  /// Whether `x` had to be folded back into the world.
  [[nodiscard]] bool reflect(Scalar& x) const {
    const auto side = static_cast<Scalar>(side_);
    if (x >= 0 && x <= side) return false;
    x = x < 0 ? -x : 2 * side - x;
    return true;
  }

  double side_;
  std::vector<Vector<D>> centers_;
  std::vector<Vector<D>> halves_;
};

/// They fly straight on, by `stride` in each step, and bounce off the walls.
template <int D>
class Flight : public Scattered<D> {
 public:
  Flight(std::uint32_t count, std::uint64_t seed, double side, double stride = kStride)
      : Scattered<D>(count, seed, side) {
    for (std::uint32_t k = 0; k < count; ++k)
      velocities_.push_back(this->direction() * static_cast<Scalar>(stride));
  }
  void advance() override {
    for (std::size_t k = 0; k < this->boxes_.size(); ++k) {
      Vector<D> center = this->centers_[k] + velocities_[k];
      for (int i = 0; i < D; ++i)
        if (this->reflect(center[i])) velocities_[k][i] = -velocities_[k][i];
      this->put(k, center);
    }
  }

 protected:
  std::vector<Vector<D>> velocities_;
};

}  // namespace kerf
