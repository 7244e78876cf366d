#include "frames/bench/random/random_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <numbers>
#include <vector>

#include "frames/bench/random/layout.h"

namespace kerf {
namespace {

/// With objects that go and come, so many are absent at a time, as a share of those present.
constexpr double kAbsent = 0.1;

std::uint32_t slots_of(const RandomScene& scene) {
  return scene.objects + (scene.churn > 0 ? static_cast<std::uint32_t>(kAbsent * scene.objects) + 1 : 0);
}

template <int D>
class RandomMotion final : public Motion<D> {
 public:
  explicit RandomMotion(const RandomScene& scene)
      : Motion<D>(~scene.seed), scene_(scene), laid_(lay_out<D>(scene, slots_of(scene), this->random_)) {
    const std::uint32_t slots = slots_of(scene);
    homes_ = laid_.centers;
    came_in_.resize(slots);
    for (std::uint32_t k = 0; k < slots; ++k) {
      this->boxes_.push_back(k < scene.objects ? box_at<D>(homes_[k], laid_.halves[k]) : no_box<D>());
      if (k >= scene.objects) absent_.push_back({k});
      headings_.push_back(heading());
    }
    this->moving_ = slots;
    this->all_move_ = false;
    this->most_changes_ = 2 * (static_cast<std::uint32_t>(scene.churn * scene.objects) + 1);
    this->box_size_ = static_cast<Scalar>(laid_.size);
    const double beyond = scene.travel == Travel::translation || scene.other == Travel::translation ? 2 : 0.5;
    Place<D> middle;
    middle.fill(laid_.side / 2);
    Place<D> half;
    half.fill((0.5 + beyond) * laid_.side);
    this->bounds_ = box_at<D>(middle, half);
  }

  void advance() override {
    this->moved_.clear();
    this->inserted_.clear();
    this->removed_.clear();
    ++step_;
    replace_some();
    const bool is_other = scene_.other && (step_ - 1) / scene_.phase % 2 == 1;
    travel(is_other ? *scene_.other : scene_.travel);
  }

 private:
  [[nodiscard]] Place<D> heading() {
    const Vector<D> way = this->direction();
    Place<D> place;
    for (int i = 0; i < D; ++i) place[static_cast<std::size_t>(i)] = way[i];
    return place;
  }

  /// As many objects go as come; those that went longest ago come, where they were at first.
  void replace_some() {
    replaced_ += scene_.churn * scene_.objects;
    while (replaced_ >= 1) {
      const ObjectId leaving{this->random_.below(static_cast<std::uint32_t>(homes_.size()))};
      if (is_absent(this->boxes_[leaving.index()]) || came_in_[leaving.index()] == step_) continue;
      replaced_ -= 1;
      const ObjectId coming = absent_.front();
      absent_.pop_front();
      absent_.push_back(leaving);
      this->removed_.push_back(leaving);
      this->inserted_.push_back(coming);
      this->boxes_[leaving.index()] = no_box<D>();
      laid_.centers[coming.index()] = homes_[coming.index()];
      put(coming);
      came_in_[coming.index()] = step_;
    }
  }
  void put(ObjectId object) {
    this->boxes_[object.index()] = box_at<D>(laid_.centers[object.index()], laid_.halves[object.index()]);
  }

  /// Moves the awake objects: a window of the numbers, which itself moves on slowly.
  void travel(Travel travel) {
    if (travel == Travel::rest) return;
    begin(travel);
    const auto slots = static_cast<std::uint32_t>(homes_.size());
    const auto awake = static_cast<std::uint32_t>(std::ceil(scene_.awake * slots));
    constexpr std::uint32_t kOneIn = 64;
    const std::uint32_t first = awake == slots ? 0 : step_ * std::max(awake / kOneIn, 1U);
    for (std::uint32_t k = 0; k < awake; ++k) {
      const ObjectId object{(first + k) % slots};
      if (is_absent(this->boxes_[object.index()]) || came_in_[object.index()] == step_) continue;
      move(travel, object.index());
      put(object);
      this->moved_.push_back(object);
    }
  }
  /// What all objects share in a step.
  void begin(Travel travel) {
    const double share = scene_.speed * laid_.size / laid_.side;
    turn_ = share / 0.35;  // the mean distance from the middle
    if (travel == Travel::explosion) spread_by(1 + 2 * share, 2);
    if (travel == Travel::collapse) spread_by(1 - std::min(2 * share, 0.2), 0.7);
  }
  /// `end`: how far from the middle they go, as a multiple of the way at first.
  void spread_by(double factor, double end) {
    returns_ = end > 1 ? spread_ * factor > end : spread_ * factor < end;
    spread_ = returns_ ? 1 : spread_ * factor;
    factor_ = factor;
  }

  void move(Travel travel, std::size_t k) {
    Place<D>& center = laid_.centers[k];
    const double stride = scene_.speed * laid_.size;
    switch (travel) {
      case Travel::brownian:
        return walk(k);
      case Travel::streams:
        return advance_along(center, headings_[k % std::min<std::size_t>(kStreams, headings_.size())], stride,
                             true);
      case Travel::translation:
        return advance_along(center, headings_.front(), stride, false);
      case Travel::rotation:
        return turn(center);
      case Travel::explosion:
      case Travel::collapse:
        return spread(k);
      case Travel::periodic:
        return advance_along(center, headings_[k], stride * std::cos(phase_of(k)), false);
      case Travel::teleports:
        return jump(k);
      case Travel::rest:
        break;
    }
  }
  /// By its own size, and never far from its first place, so that the layout remains.
  void walk(std::size_t k) {
    constexpr double kTether = 12;
    Place<D>& center = laid_.centers[k];
    for (std::size_t i = 0; i < D; ++i) {
      const double stride = scene_.speed * 2 * laid_.halves[k][i];
      const double way = this->random_.uniform(-stride, stride);
      const bool is_far = std::abs(center[i] + way - homes_[k][i]) > kTether * std::max(laid_.size, stride);
      center[i] += is_far ? -way : way;
    }
  }
  void advance_along(Place<D>& center, const Place<D>& way, double stride, bool wraps) {
    for (std::size_t i = 0; i < D; ++i) {
      center[i] += way[i] * stride;
      if (!wraps) continue;
      if (center[i] < 0) center[i] += laid_.side;
      if (center[i] > laid_.side) center[i] -= laid_.side;
    }
  }
  void turn(Place<D>& center) const {
    const double x = center[0] - laid_.side / 2;
    const double y = center[1] - laid_.side / 2;
    center[0] += x * (std::cos(turn_) - 1) - y * std::sin(turn_);
    center[1] += x * std::sin(turn_) + y * (std::cos(turn_) - 1);
  }
  [[nodiscard]] double phase_of(std::size_t k) const {
    return 2 * std::numbers::pi * (static_cast<double>((step_ + k) % kPeriod) + 0.5) / kPeriod;
  }
  void spread(std::size_t k) {
    Place<D>& center = laid_.centers[k];
    for (std::size_t i = 0; i < D; ++i)
      center[i] = returns_ ? homes_[k][i] : laid_.side / 2 + (center[i] - laid_.side / 2) * factor_;
  }
  void jump(std::size_t k) {
    const Place<D>& target = homes_[this->random_.below(static_cast<std::uint32_t>(homes_.size()))];
    for (std::size_t i = 0; i < D; ++i)
      laid_.centers[k][i] = target[i] + this->random_.uniform(-1, 1) * laid_.size;
  }

  static constexpr std::size_t kStreams = 4;
  static constexpr std::size_t kPeriod = 40;  ///< steps of a movement to and fro

  RandomScene scene_;
  LaidOut<D> laid_;  ///< its centres are where the objects are now
  std::vector<Place<D>> homes_;
  std::vector<Place<D>> headings_;
  std::deque<ObjectId> absent_;
  std::vector<std::uint32_t> came_in_;  ///< by object, the last step in which it came
  std::uint32_t step_ = 0;
  double replaced_ = 0;  ///< objects that are to be replaced
  double turn_ = 0;      ///< radians a step
  double spread_ = 1;    ///< distances from the middle, as a multiple of those at first
  double factor_ = 1;    ///< by which they change in this step
  bool returns_ = false;
};

}  // namespace

template <int D>
std::unique_ptr<Motion<D>> make_random_motion(const RandomScene& scene) {
  return std::make_unique<RandomMotion<D>>(scene);
}

template std::unique_ptr<Motion<2>> make_random_motion(const RandomScene&);
template std::unique_ptr<Motion<3>> make_random_motion(const RandomScene&);

}  // namespace kerf
