#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "frames/bench/motion.h"

namespace kerf {
inline constexpr std::uint32_t kAttractors = 8;
inline constexpr double kPairsInClouds = 4;
inline constexpr double kSpeed = 0.3;  ///< root of the mean square along an axis, in usual extents a step
inline constexpr std::uint32_t kFaithful = 500;  ///< steps between changes of attractor, on average

/// Eight wandering attractors; everything starts scattered, collapses into swirling clouds of Gaussian
/// density and sometimes changes its attractor. About 4 pairs an object on average, more in the hearts of
/// clouds.
/// The Langevin equation in a harmonic well: objects swirl and settle into a Gaussian cloud. A cloud of m
/// boxes of extent 1 and deviation s has m * 2^(D-1) / ((4 pi)^(D/2) s^D) pairs an object, which gives s.
template <int D>
class Attractors final : public Motion<D> {
 public:
  Attractors(std::uint32_t count, std::uint64_t seed)
      : Motion<D>(seed), deviation_(deviation_for(count)), side_((D == 2 ? 16 : 10) * deviation_) {
    this->moving_ = count;
    this->bounds_ = this->cube(side_);
    for (auto& phase : phases_) phase = this->vector_within(0, 2 * std::numbers::pi);
    for (std::uint32_t k = 0; k < count; ++k) {
      members_.push_back(
          {this->vector_within(0, side_), this->usual_half(), {}, this->random_.below(kAttractors)});
      this->boxes_.push_back(this->around(members_[k].center, members_[k].half));
    }
  }
  void advance() override {
    ++step_;
    for (std::uint32_t a = 0; a < kAttractors; ++a) attractors_[a] = place_of(a);
    for (std::size_t k = 0; k < members_.size(); ++k) {
      drive(members_[k]);
      this->boxes_[k] = this->around(members_[k].center, members_[k].half);
    }
  }

 private:
  struct Member {
    Vector<D> center;
    Vector<D> half;
    Vector<D> velocity;
    std::uint32_t attractor = 0;
  };

  static double deviation_for(std::uint32_t count) {
    const double in_cloud = static_cast<double>(count) / kAttractors;
    const double per_volume = std::exp2(D - 1) / std::pow(4 * std::numbers::pi, D / 2.0);
    return std::pow(in_cloud * per_volume / kPairsInClouds, 1.0 / D);
  }
  /// Lissajous figures around the middle of the world, slower than the objects.
  [[nodiscard]] Vector<D> place_of(std::uint32_t attractor) const {
    Vector<D> place;
    const double time = 0.3 * kSpeed / side_ * step_;
    for (int i = 0; i < D; ++i) {
      const double angle = phases_[attractor][i] + time * (1 + 0.31 * i + 0.17 * attractor);
      place[i] = static_cast<Scalar>(side_ * (0.5 + 0.35 * std::sin(angle)));
    }
    return place;
  }
  void drive(Member& member) {
    constexpr double kFriction = 0.1;
    const double frequency = kSpeed / deviation_;
    const auto pull = static_cast<Scalar>(frequency * frequency);
    // Uniform noise of the variance that keeps the speed: 2 * friction * speed^2.
    const double noise = kSpeed * std::sqrt(6 * kFriction);
    if (this->random_.below(kFaithful) == 0) member.attractor = this->random_.below(kAttractors);
    const Vector<D> away = member.center - attractors_[member.attractor];
    member.velocity = member.velocity * static_cast<Scalar>(1 - kFriction) - away * pull +
                      this->vector_within(-noise, noise);
    member.center = member.center + member.velocity;
  }

  double deviation_;
  double side_;
  std::uint32_t step_ = 0;
  std::array<Vector<D>, kAttractors> phases_;
  std::array<Vector<D>, kAttractors> attractors_;
  std::vector<Member> members_;
};

}  // namespace kerf
