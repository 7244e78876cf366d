#pragma once

#include <utility>
#include <vector>

#include "frames/bench/motions/scattered.h"

namespace kerf {
/// Random walk by up to 0.75 of a usual extent along each axis and step: no step resembles the next.
template <int D>
class Brownian : public Scattered<D> {
 public:
  Brownian(std::uint32_t count, std::uint64_t seed) : Scattered<D>(count, seed, side_for(count, D)) {}
  void advance() override {
    for (std::size_t k = 0; k < this->boxes_.size(); ++k) {
      Vector<D> center = this->centers_[k] + this->vector_within(-kStride, kStride);
      for (int i = 0; i < D; ++i) static_cast<void>(this->reflect(center[i]));
      this->put(k, center);
    }
  }
};

/// The same for 20 steps, then all rest for 40, alternately.
template <int D>
class Pauses final : public Brownian<D> {
 public:
  Pauses(std::uint32_t count, std::uint64_t seed) : Brownian<D>(count, seed) {
    this->all_move_ = false;
    for (std::uint32_t k = 0; k < count; ++k) all_.push_back({k});
  }
  void advance() override {
    constexpr std::uint32_t kFlight = 20;
    constexpr std::uint32_t kPause = 40;
    this->moved_.clear();
    if (step_++ % (kFlight + kPause) >= kFlight) return;
    Brownian<D>::advance();
    this->moved_ = all_;
  }

 private:
  std::vector<ObjectId> all_;
  std::uint32_t step_ = 0;
};

/// Everything is somewhere else in each step.
template <int D>
class Teleport final : public Scattered<D> {
 public:
  Teleport(std::uint32_t count, std::uint64_t seed) : Scattered<D>(count, seed, side_for(count, D)) {}
  void advance() override {
    for (std::size_t k = 0; k < this->boxes_.size(); ++k) this->put(k, this->vector_within(0, this->side_));
  }
};

/// One in twenty walks, by up to 0.3 of a usual extent, the others rest; the walkers change slowly. Resting
/// objects are not fixed: their pairs belong to the complete set.
template <int D>
class MostlyStatic : public Scattered<D> {
 public:
  MostlyStatic(std::uint32_t count, std::uint64_t seed) : Scattered<D>(count, seed, side_for(count, D)) {
    this->all_move_ = false;
    order_.resize(count);
    for (std::uint32_t k = 0; k < count; ++k) order_[k] = {k};
    for (std::uint32_t k = count; k > 1; --k) std::swap(order_[k - 1], order_[this->random_.below(k)]);
  }
  void advance() override {
    constexpr double kWalk = 0.3;
    change_guard();
    this->moved_.assign(order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(awake()));
    for (const ObjectId object : this->moved_) {
      Vector<D> center = this->centers_[object.index()] + this->vector_within(-kWalk, kWalk);
      for (int i = 0; i < D; ++i) static_cast<void>(this->reflect(center[i]));
      this->put(object.index(), center);
    }
  }

 private:
  [[nodiscard]] std::uint32_t awake() const {
    constexpr std::uint32_t kOneIn = 20;
    return this->moving_ / kOneIn;
  }
  /// One in 64 of the awake objects changes places with a resting one.
  void change_guard() {
    constexpr std::uint32_t kOneIn = 64;
    const std::uint32_t resting = this->moving_ - awake();
    for (std::uint32_t k = 0; k < awake() / kOneIn; ++k) {
      const std::uint32_t tired = this->random_.below(awake());
      std::swap(order_[tired], order_[awake() + this->random_.below(resting)]);
    }
  }

  std::vector<ObjectId> order_;  ///< the awake ones come first
};

/// Mostly static, but the origin is moved by the world's diagonal, there or back, in every tenth step.
/// The same world, seen from an origin that goes away and comes back again.
template <int D>
class Shifts final : public MostlyStatic<D> {
 public:
  Shifts(std::uint32_t count, std::uint64_t seed) : MostlyStatic<D>(count, seed) {
    this->bounds_ = this->cube(2 * this->side_);
  }
  void advance() override {
    MostlyStatic<D>::advance();
    if (++step_ % kInterval == 0) {
      is_away_ = !is_away_;
      this->moved_.clear();
      for (std::uint32_t k = 0; k < this->moving_; ++k) this->moved_.push_back({k});
    }
    const Vector<D> by = this->along_all(is_away_ ? this->side_ : 0);
    for (const ObjectId object : this->moved_)
      this->boxes_[object.index()] =
          this->around(this->centers_[object.index()] + by, this->halves_[object.index()]);
  }

 private:
  static constexpr std::uint32_t kInterval = 10;
  std::uint32_t step_ = 0;
  bool is_away_ = false;
};

}  // namespace kerf
