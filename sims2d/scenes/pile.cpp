#include <algorithm>
#include <cmath>

#include "sims2d/scenes/fixed.h"
#include "sims2d/scenes/growth.h"
#include "sims2d/scenes/rain.h"
#include "sims2d/scenes/scene_entries.h"

namespace kerf::inline sims2d {
namespace {

constexpr std::uint32_t kDefaultObjects = 1200;

/// Free directions do not pay, in spite of the slopes: measured with 4,250 objects, axis partitioners leave
/// as few straddlers (redundancy 0.17) in a tree of the same height and cost 10 to 15 % less time.
constexpr Needs kNeeds{.dimension = 2, .free_directions = false, .separating = {true, true, false}};

std::unique_ptr<Scene<2>> make(BroadPhase<2>& broad_phase, const SceneOptions& options) {
  RainPlan plan;
  plan.needs = kNeeds;
  plan.growth = growth_of(options, kDefaultObjects);
  // An object needs about 0.8 square units: levelled out, all of them stand less than half a unit high.
  const Scalar unit = std::max(std::sqrt(static_cast<Scalar>(plan.growth.objects)), 4.0F);
  const Scalar half_width = 0.9F * unit;
  const Scalar height = 1.2F * unit;
  plan.fixed = yard(half_width, height);
  plan.fixed.push_back(fixed_brick({{-0.5F * half_width, 0.85F * unit}}, {{0.2F * half_width, 0.3F}}, -0.6F));
  plan.fixed.push_back(fixed_brick({{0.5F * half_width, 0.85F * unit}}, {{0.2F * half_width, 0.3F}}, 0.6F));
  plan.band = {-0.7F * half_width, 0.7F * half_width, height + 1};
  return std::make_unique<RainScene>(broad_phase, plan, options.seed);
}

}  // namespace

SceneEntry<2> pile_entry() {
  return {.name = "pile",
          .summary = "discs, rectangles and polygons fall into a heap between two walls",
          .source = "ours, after simulation 1 of the paper",
          .default_objects = kDefaultObjects,
          .needs = kNeeds,
          .make = make};
}

}  // namespace kerf::inline sims2d
