#include <algorithm>
#include <cmath>

#include "sims2d/scenes/fixed.h"
#include "sims2d/scenes/growth.h"
#include "sims2d/scenes/rain.h"
#include "sims2d/scenes/scene_entries.h"

namespace kerf::inline sims2d {
namespace {

constexpr std::uint32_t kDefaultObjects = 1200;
constexpr int kBuckets = 4;
constexpr Scalar kWall = 0.3F;   ///< half the thickness
constexpr Scalar kLean = 0.18F;  ///< of the walls, outwards, in radians

/// Buckets stand side by side and axis partitioners part them; free directions leave fewer straddlers once
/// the buckets are full (redundancy 0.17 against 0.19 with 4,250 objects), but cost more time than that
/// saves.
constexpr Needs kNeeds{.dimension = 2, .free_directions = false, .separating = {true, true, false}};

/// A bucket with an inside of `width` at its floor and walls of length `height`, standing on the ground.
void add_bucket(std::vector<BodyPlan>& bodies, Scalar center, Scalar width, Scalar height) {
  bodies.push_back(fixed_brick({{center, kWall}}, {{width / 2, kWall}}));
  for (const Scalar side : {-1.0F, 1.0F}) {
    const Scalar x = center + side * (width / 2 + kWall + std::sin(kLean) * height / 2);
    bodies.push_back(fixed_brick({{x, std::cos(kLean) * height / 2}}, {{kWall, height / 2}}, -side * kLean));
  }
}

std::unique_ptr<Scene<2>> make(BroadPhase<2>& broad_phase, const SceneOptions& options) {
  RainPlan plan;
  plan.needs = kNeeds;
  plan.growth = growth_of(options, kDefaultObjects);
  // All buckets together hold nine of ten objects.
  const Scalar width = std::max(0.33F * std::sqrt(static_cast<Scalar>(plan.growth.objects)), 3.0F);
  const Scalar height = 1.4F * width;
  const Scalar mouth = width + 4 * kWall + 2 * std::sin(kLean) * height;
  const Scalar pitch = mouth + 3;
  const Scalar half_width = pitch * kBuckets / 2 + 1;
  plan.fixed = yard(half_width, 2 * height);
  for (int i = 0; i < kBuckets; ++i)
    add_bucket(plan.fixed, pitch * (static_cast<Scalar>(i) - (kBuckets - 1) / 2.0F), width, height);
  const Scalar reach = pitch * (kBuckets - 1) / 2 + mouth / 2;
  plan.band = {-reach, reach, 2 * height + 1};
  return std::make_unique<RainScene>(broad_phase, plan, options.seed);
}

}  // namespace

SceneEntry<2> buckets_entry() {
  return {.name = "buckets",
          .summary = "objects fall into four buckets with slanted walls",
          .source = "paper, simulation 4, in 2D",
          .default_objects = kDefaultObjects,
          .needs = kNeeds,
          .make = make};
}

}  // namespace kerf::inline sims2d
