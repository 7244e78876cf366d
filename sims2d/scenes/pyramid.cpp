#include <algorithm>

#include "core/base/random.h"
#include "core/scene/world_scene.h"
#include "sims2d/scenes/fixed.h"
#include "sims2d/scenes/growth.h"
#include "sims2d/scenes/scene_entries.h"
#include "sims2d/world.h"

namespace kerf::inline sims2d {
namespace {

constexpr std::uint32_t kDefaultObjects = 379;
constexpr Scalar kHalf = 0.5F;
constexpr Scalar kPitch = 1.12F;      ///< of blocks in a row
constexpr Scalar kRowPitch = 1.001F;  ///< a hair of air, so that nothing is pressed apart
constexpr Scalar kRadius = 3;
constexpr Scalar kDropHeight = 12;  ///< of the disc, above the pyramid's top

constexpr Needs kNeeds{.dimension = 2, .free_directions = false, .separating = {true, true, false}};

/// Blocks of the lowest row of the smallest pyramid that has so many.
std::uint32_t base_of(std::uint32_t blocks) {
  std::uint32_t base = 1;
  while (std::uint64_t{base} * (base + 1) / 2 < blocks) ++base;
  return base;
}

class PyramidScene final : public WorldScene<2, Box2dWorld> {
 public:
  PyramidScene(BroadPhase<2>& broad_phase, std::uint32_t objects, std::uint64_t seed)
      : WorldScene(broad_phase, kNeeds) {
    const std::uint32_t base = base_of(objects - 1);
    const Scalar half_width = kPitch * static_cast<Scalar>(base) / 2 + 8;
    const Scalar height = kRowPitch * static_cast<Scalar>(base) + kDropHeight;
    for (const BodyPlan& plan : yard(half_width, height)) world().add(plan);
    BodyPlan disc;
    disc.shape = Ball{kRadius};
    disc.position = {{static_cast<Scalar>(Random(seed).uniform(-2, 2)), height}};
    world().add(disc);
    std::uint32_t left = objects - 1;
    for (std::uint32_t row = 0; left > 0; ++row) {
      const std::uint32_t blocks = std::min(left, base - row);
      for (std::uint32_t k = 0; k < blocks; ++k) add_block(base, row, k);
      left -= blocks;
    }
  }

 private:
  void add_block(std::uint32_t base, std::uint32_t row, std::uint32_t k) {
    BodyPlan plan;
    plan.shape = Brick<2>{{{kHalf, kHalf}}};
    const Scalar across = static_cast<Scalar>(k) - static_cast<Scalar>(base - row - 1) / 2;
    plan.position = {{across * kPitch, kHalf + static_cast<Scalar>(row) * kRowPitch}};
    world().add(plan);
  }

  void act() override {}
};

}  // namespace

SceneEntry<2> pyramid_entry() {
  return {.name = "pyramid",
          .summary = "a standing pyramid of blocks, onto which a disc falls",
          .source = "ours, after Box2D's test bed",
          .default_objects = kDefaultObjects,
          .needs = kNeeds,
          .make = make_at_once<PyramidScene, kDefaultObjects>,
          .grows = false,
          .parameters = "objects: the disc and the blocks, from the first step; seed: where the disc falls"};
}

}  // namespace kerf::inline sims2d
