#pragma once

#include <cmath>
#include <vector>

#include "frames/bench/motion.h"

namespace kerf {
inline constexpr double kLongest = 8;

/// Needles of length 1 to 8, nearly diagonal, that fly lengthwise and turn. Their boxes are large and differ
/// much in size.
/// The direction of a needle: within some 25 degrees of a diagonal, to which it swings back.
template <int D>
class Needles final : public Motion<D> {
 public:
  Needles(std::uint32_t count, std::uint64_t seed)
      : Motion<D>(seed), side_(side_for(count, D, mean_extent())) {
    this->moving_ = count;
    this->bounds_ = this->cube(side_);
    this->box_size_ = static_cast<Scalar>(mean_extent());
    for (std::uint32_t k = 0; k < count; ++k) {
      needles_.push_back(random_needle());
      this->boxes_.push_back(box_of(needles_[k]));
    }
  }
  void advance() override {
    for (std::size_t k = 0; k < needles_.size(); ++k) {
      fly(needles_[k]);
      this->boxes_[k] = box_of(needles_[k]);
    }
  }

 private:
  struct Needle {
    Vector<D> center;
    Vector<D> diagonal;  ///< components +-1/sqrt(D)
    Vector<D> tilt;
    Scalar length = 1;
    Scalar speed = 0;
  };

  /// Lengths are spread evenly by logarithm, so their mean is (longest - 1) / ln(longest).
  static double mean_extent() { return (kLongest - 1) / std::log(kLongest) / std::sqrt(D) + 2 * kThickness; }
  Needle random_needle() {
    Needle needle;
    needle.center = this->vector_within(0, side_);
    for (int i = 0; i < D; ++i)
      needle.diagonal[i] = static_cast<Scalar>((this->random_.below(2) == 0 ? 1 : -1) / std::sqrt(D));
    needle.tilt = this->vector_within(-kTilt, kTilt);
    needle.length = static_cast<Scalar>(std::exp(this->uniform(0, std::log(kLongest))));
    needle.speed = static_cast<Scalar>(this->uniform(-kFastest, kFastest));
    return needle;
  }
  static Box<D> box_of(const Needle& needle) {
    Vector<D> half = needle.diagonal + needle.tilt;
    const Scalar scale = needle.length / 2 / length(half);
    for (int i = 0; i < D; ++i) half[i] = std::abs(half[i]) * scale + kThickness;
    return Motion<D>::around(needle.center, half);
  }
  void fly(Needle& needle) {
    constexpr double kTurn = 0.03;
    needle.tilt = needle.tilt * static_cast<Scalar>(1 - kTurn) + this->vector_within(-kTurn, kTurn);
    needle.center = needle.center + (needle.diagonal + needle.tilt) * needle.speed;
    for (int i = 0; i < D; ++i)
      if (needle.center[i] < 0 || needle.center[i] > static_cast<Scalar>(side_)) turn_back(needle, i);
  }
  void turn_back(Needle& needle, int axis) const {
    needle.center[axis] = needle.center[axis] < 0 ? 0 : static_cast<Scalar>(side_);
    needle.diagonal[axis] = -needle.diagonal[axis];
    needle.tilt[axis] = -needle.tilt[axis];
  }

  static constexpr Scalar kThickness = 0.05F;
  static constexpr double kTilt = 0.25;
  static constexpr double kFastest = 0.4;
  double side_;
  std::vector<Needle> needles_;
};

}  // namespace kerf
