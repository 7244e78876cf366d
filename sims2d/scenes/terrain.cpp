#include <algorithm>
#include <vector>

#include "core/base/random.h"
#include "sims2d/scenes/fixed.h"
#include "sims2d/scenes/growth.h"
#include "sims2d/scenes/rain.h"
#include "sims2d/scenes/scene_entries.h"

namespace kerf::inline sims2d {
namespace {

constexpr std::uint32_t kDefaultObjects = 1000;
constexpr Scalar kColumn = 1.5F;  ///< width of a column of ground
constexpr Scalar kGround = 1;     ///< least height of a column
constexpr Scalar kWidthPerObject = 0.1F;
constexpr Scalar kMinWidth = 60;
constexpr Scalar kSiteHeight = 8;  ///< of the band above the highest hill

// The seed of the landscape differs from that of the objects.
constexpr std::uint64_t kLandscapeStream = 0x7E44A1;

constexpr Needs kNeeds{.dimension = 2,
                       .free_directions = false,  // columns stand along the axes
                       .separating = {true, false, false}};

/// Heights at the columns' sides: smooth bumps at random places, none of them steep.
std::vector<Scalar> hills(std::size_t columns, Random random) {
  std::vector<Scalar> heights(columns + 1, kGround);
  const double width = static_cast<double>(columns) * kColumn;
  for (double placed = 0; placed < width; placed += 8) {
    const double middle = random.uniform(0, width);
    const double radius = random.uniform(6, 14);
    const double amplitude = random.uniform(1, 0.35 * radius);
    for (std::size_t k = 0; k < heights.size(); ++k) {
      const double x = (static_cast<double>(k) * kColumn - middle) / radius;
      if (x * x < 1) heights[k] += static_cast<Scalar>(amplitude * (1 - x * x) * (1 - x * x));
    }
  }
  return heights;
}

/// A column of ground from y = 0 up to a slanted top.
BodyPlan column(Scalar left, Scalar left_height, Scalar right_height) {
  BodyPlan plan;
  plan.mobility = Mobility::fixed;
  plan.position = {{left, 0}};
  plan.shape = Outline{{{{0, 0}}, {{kColumn, 0}}, {{kColumn, right_height}}, {{0, left_height}}}};
  return plan;
}

std::unique_ptr<Scene<2>> make(BroadPhase<2>& broad_phase, const SceneOptions& options) {
  RainPlan plan;
  plan.needs = kNeeds;
  plan.growth = growth_of(options, kDefaultObjects);
  const Scalar width = std::max(kWidthPerObject * static_cast<Scalar>(plan.growth.objects), kMinWidth);
  const auto columns = static_cast<std::size_t>(width / kColumn);
  const Scalar half_width = kColumn * static_cast<Scalar>(columns) / 2;
  const std::vector<Scalar> heights = hills(columns, Random(options.seed ^ kLandscapeStream));
  const Scalar top = *std::max_element(heights.begin(), heights.end());
  plan.fixed = yard(half_width, top + kSiteHeight);
  for (std::size_t k = 0; k < columns; ++k)
    plan.fixed.push_back(column(kColumn * static_cast<Scalar>(k) - half_width, heights[k], heights[k + 1]));
  plan.band = {-half_width + 1, half_width - 1, top + kSiteHeight + 1};
  return std::make_unique<RainScene>(broad_phase, plan, options.seed);
}

}  // namespace

SceneEntry<2> terrain_entry() {
  return {.name = "terrain",
          .summary = "discs, rectangles and polygons fall onto hills made of many fixed columns",
          .source = "paper, simulation 1, in 2D",
          .default_objects = kDefaultObjects,
          .needs = kNeeds,
          .make = make};
}

}  // namespace kerf::inline sims2d
