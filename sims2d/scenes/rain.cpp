#include "sims2d/scenes/rain.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "core/scene/nudge.h"

namespace kerf::inline sims2d {
namespace {

Scalar between(Random& random, double low, double high) {
  return static_cast<Scalar>(random.uniform(low, high));
}

Shape<2> random_brick(Random& random) {
  Brick<2> brick;
  brick.half[0] = between(random, 0.35, 0.55);
  brick.half[1] = between(random, 0.35, 0.55);
  return brick;
}

/// Corners on a circle, moved along it by less than a quarter of their distance: always convex.
Shape<2> random_outline(Random& random) {
  const std::uint32_t corners = 3 + random.below(6);
  const double radius = random.uniform(0.5, 0.65);
  Outline outline;
  for (std::uint32_t i = 0; i < corners; ++i) {
    const double angle = (i + random.uniform(-0.2, 0.2)) * 2 * std::numbers::pi / corners;
    const auto x = static_cast<Scalar>(radius * std::cos(angle));
    const auto y = static_cast<Scalar>(radius * std::sin(angle));
    outline.corners.push_back({{x, y}});
  }
  return outline;
}

}  // namespace

Shape<2> random_shape(Random& random) {
  switch (random.below(3)) {
    case 0:
      return Ball{between(random, 0.35, 0.6)};
    case 1:
      return random_brick(random);
    default:
      return random_outline(random);
  }
}

Rain::Rain(const Band& band, const Growth& growth, std::uint64_t seed)
    : band_(band), growth_(growth), random_(seed), row_height_(band.bottom - kSlot) {}

void Rain::fall(Box2dWorld& world, std::uint32_t step) {
  row_height_ -= Box2dWorld::kFallSpeed * Box2dWorld::kStepSeconds;
  for (const std::uint32_t due = growth_.due(step); fallen_ < due; ++fallen_) {
    BodyPlan plan = next();
    if (fallen_ == 0) plan.position = nudged(plan.position, growth_.nudge);
    objects_.push_back(world.add(plan));
  }
  recycle(world, step);
}

/// Keeps a full scene in motion: the oldest object is taken out of the heap and falls again.
void Rain::recycle(Box2dWorld& world, std::uint32_t step) {
  if (growth_.recycle == 0 || step <= growth_.steps || step % growth_.recycle != 0 || objects_.empty())
    return;
  world.place(objects_[recycled_++ % objects_.size()], next());
}

void Rain::begin_row() {
  row_height_ = std::max(band_.bottom, row_height_ + kSlot);
  slots_.resize(static_cast<std::size_t>((band_.right - band_.left) / kSlot));
  std::iota(slots_.begin(), slots_.end(), 0U);
  for (std::size_t left = slots_.size(); left > 1; --left)
    std::swap(slots_[left - 1], slots_[random_.below(static_cast<std::uint32_t>(left))]);
}

BodyPlan Rain::next() {
  if (slots_.empty() || row_height_ < band_.bottom) begin_row();
  // The largest object reaches 0.78 from its middle, half a slot is 0.85.
  const Scalar shift = between(random_, -0.06, 0.06);
  BodyPlan plan;
  plan.shape = random_shape(random_);
  plan.angle = between(random_, -std::numbers::pi, std::numbers::pi);
  plan.spin = between(random_, -2, 2);
  plan.position = {{band_.left + (static_cast<Scalar>(slots_.back()) + 0.5F) * kSlot + shift, row_height_}};
  plan.velocity = {{0, -Box2dWorld::kFallSpeed}};
  slots_.pop_back();
  return plan;
}

RainScene::RainScene(BroadPhase<2>& broad_phase, const RainPlan& plan, std::uint64_t seed)
    : WorldScene(broad_phase, plan.needs), rain_(plan.band, plan.growth, seed) {
  for (const BodyPlan& body : plan.fixed) world().add(body);
}

}  // namespace kerf::inline sims2d
