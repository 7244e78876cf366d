#include <utility>
#include <vector>

#include "frames/bench/motions/motions.h"
#include "frames/bench/motions/scattered.h"

namespace kerf {
namespace {

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

template <int D>
class Teleport final : public Scattered<D> {
 public:
  Teleport(std::uint32_t count, std::uint64_t seed) : Scattered<D>(count, seed, side_for(count, D)) {}
  void advance() override {
    for (std::size_t k = 0; k < this->boxes_.size(); ++k) this->put(k, this->vector_within(0, this->side_));
  }
};

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

}  // namespace

template <int D>
std::unique_ptr<Motion<D>> make_brownian(std::uint32_t count, std::uint64_t seed) {
  return std::make_unique<Brownian<D>>(count, seed);
}

template <int D>
std::unique_ptr<Motion<D>> make_pauses(std::uint32_t count, std::uint64_t seed) {
  return std::make_unique<Pauses<D>>(count, seed);
}

template <int D>
std::unique_ptr<Motion<D>> make_uniform(std::uint32_t count, std::uint64_t seed) {
  return std::make_unique<Flight<D>>(count, seed, side_for(count, D));
}

template <int D>
std::unique_ptr<Motion<D>> make_teleport(std::uint32_t count, std::uint64_t seed) {
  return std::make_unique<Teleport<D>>(count, seed);
}

template <int D>
std::unique_ptr<Motion<D>> make_mostly_static(std::uint32_t count, std::uint64_t seed) {
  return std::make_unique<MostlyStatic<D>>(count, seed);
}

template <int D>
std::unique_ptr<Motion<D>> make_shifts(std::uint32_t count, std::uint64_t seed) {
  return std::make_unique<Shifts<D>>(count, seed);
}

template std::unique_ptr<Motion<2>> make_brownian<2>(std::uint32_t, std::uint64_t);
template std::unique_ptr<Motion<3>> make_brownian<3>(std::uint32_t, std::uint64_t);
template std::unique_ptr<Motion<2>> make_pauses<2>(std::uint32_t, std::uint64_t);
template std::unique_ptr<Motion<3>> make_pauses<3>(std::uint32_t, std::uint64_t);
template std::unique_ptr<Motion<2>> make_uniform<2>(std::uint32_t, std::uint64_t);
template std::unique_ptr<Motion<3>> make_uniform<3>(std::uint32_t, std::uint64_t);
template std::unique_ptr<Motion<2>> make_teleport<2>(std::uint32_t, std::uint64_t);
template std::unique_ptr<Motion<3>> make_teleport<3>(std::uint32_t, std::uint64_t);
template std::unique_ptr<Motion<2>> make_mostly_static<2>(std::uint32_t, std::uint64_t);
template std::unique_ptr<Motion<3>> make_mostly_static<3>(std::uint32_t, std::uint64_t);
template std::unique_ptr<Motion<2>> make_shifts<2>(std::uint32_t, std::uint64_t);
template std::unique_ptr<Motion<3>> make_shifts<3>(std::uint32_t, std::uint64_t);

}  // namespace kerf
