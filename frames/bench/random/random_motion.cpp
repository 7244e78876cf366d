#include "frames/bench/random/random_motion.h"

#include <algorithm>
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
  RandomMotion(const RandomScene& scene, std::uint32_t steps)
      : Motion<D>(~scene.seed), scene_(scene), laid_(lay_out<D>(scene, slots_of(scene), this->random_)) {
    homes_ = laid_.centers;
    for (std::size_t k = 0; k < homes_.size(); ++k) headings_.push_back(heading());
    this->moving_ = slots_of(scene);
    this->all_move_ = false;
    this->most_changes_ = 2 * (static_cast<std::uint32_t>(scene.churn * scene.objects) + 1);
    this->box_size_ = static_cast<Scalar>(laid_.size);
    begin_anew();
    look_ahead(steps);
  }

  void advance() override { go_on(); }

 private:
  void begin_anew() {
    laid_.centers = homes_;
    came_in_.assign(homes_.size(), 0);
    spread_.assign(homes_.size(), 1);
    absent_.clear();
    this->boxes_.assign(homes_.size(), no_box<D>());
    for (std::uint32_t k = 0; k < homes_.size(); ++k) {
      if (k < scene_.objects) {
        put({k});
      } else {
        absent_.push_back({k});
      }
    }
    step_ = 0;
    replaced_ = 0;
    clear_changes();
  }
  /// The bounds are those of the motion as it will be: a library that needs them gets what is true of the
  /// scene, with a size to spare.
  void look_ahead(std::uint32_t steps) {
    const Random random = this->random_;
    Box<D> bounds = no_box<D>();
    for (std::uint32_t step = 0;; ++step) {
      for (const Box<D>& box : this->boxes_) bounds = join(bounds, box);
      if (step == steps) break;
      go_on();
    }
    const Vector<D> margin = Motion<D>::along_all(laid_.size);
    this->bounds_ = {bounds.min - margin, bounds.max + margin};
    this->random_ = random;
    begin_anew();
  }
  void clear_changes() {
    this->moved_.clear();
    this->inserted_.clear();
    this->removed_.clear();
  }
  void go_on() {
    clear_changes();
    ++step_;
    replace_some();
    const bool is_other = scene_.other && (step_ - 1) / scene_.phase % 2 == 1;
    travel(is_other ? *scene_.other : scene_.travel);
  }

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
      spread_[coming.index()] = 1;
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
  void move(Travel travel, std::size_t k) {
    Place<D>& center = laid_.centers[k];
    const double stride = scene_.speed * laid_.size;
    const double share = stride / laid_.side;
    switch (travel) {
      case Travel::brownian:
        return walk(k);
      case Travel::streams:
        return advance_along(center, headings_[k % std::min<std::size_t>(kStreams, headings_.size())], stride,
                             true);
      case Travel::translation:
        return advance_along(center, headings_.front(), stride, false);
      case Travel::rotation:
        return turn(center, share / 0.35);  // the mean distance from the middle
      case Travel::explosion:
        return spread(k, 1 + 2 * share, 2);
      case Travel::collapse:
        return spread(k, 1 - std::min(2 * share, 0.2), 0.7);
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
  void turn(Place<D>& center, double radians) const {
    const double x = center[0] - laid_.side / 2;
    const double y = center[1] - laid_.side / 2;
    center[0] += x * (std::cos(radians) - 1) - y * std::sin(radians);
    center[1] += x * std::sin(radians) + y * (std::cos(radians) - 1);
  }
  [[nodiscard]] double phase_of(std::size_t k) const {
    return 2 * std::numbers::pi * (static_cast<double>((step_ + k) % kPeriod) + 0.5) / kPeriod;
  }
  /// `end`: how far from the middle it goes, as a multiple of the way at first; then it is back at once.
  void spread(std::size_t k, double factor, double end) {
    Place<D>& center = laid_.centers[k];
    spread_[k] *= factor;
    const bool returns = end > 1 ? spread_[k] > end : spread_[k] < end;
    if (returns) spread_[k] = 1;
    for (std::size_t i = 0; i < D; ++i)
      center[i] = returns ? homes_[k][i] : laid_.side / 2 + (center[i] - laid_.side / 2) * factor;
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
  std::vector<double> spread_;          ///< by object, its way from the middle as a multiple of that at first
  std::uint32_t step_ = 0;
  double replaced_ = 0;  ///< objects that are to be replaced
};

}  // namespace

template <int D>
std::unique_ptr<Motion<D>> make_random_motion(const RandomScene& scene, std::uint32_t steps) {
  return std::make_unique<RandomMotion<D>>(scene, steps);
}

template std::unique_ptr<Motion<2>> make_random_motion(const RandomScene&, std::uint32_t);
template std::unique_ptr<Motion<3>> make_random_motion(const RandomScene&, std::uint32_t);

}  // namespace kerf
