#include <algorithm>

#include "core/base/random.h"
#include "core/scene/world_scene.h"
#include "sims3d/scenes/drop_scene.h"
#include "sims3d/scenes/scene_entries.h"
#include "sims3d/scenes/yard.h"
#include "sims3d/world.h"

namespace kerf {
namespace {

constexpr std::uint32_t kDefaultObjects = 500;
constexpr Scalar kRadius = 1.6F;
constexpr Scalar kSpeed = 45;  // 1.8 units a step: less than the ball is across
constexpr std::uint32_t kFirstShot = 25;
constexpr std::uint32_t kBetweenShots = 100;
constexpr Scalar kHalfBlock = 0.45F;
constexpr Scalar kPitch = 0.94F;
constexpr Scalar kLayerPitch = 0.9F + 0x1p-7F;
constexpr std::uint32_t kLayers = 8;
constexpr std::uint32_t kDepth = 3;  // blocks along X, through which the ball is shot
constexpr Scalar kApron = 14;        // floor around the stack, on which blocks come to rest
constexpr Scalar kFence = 2;
constexpr double kBlockSpeed = 16;  // the terminal speed of blocks: 0.64 units a step

constexpr Needs kNeeds{.dimension = 3,
                       .volume = VolumeKind::box,
                       .fixed_objects = true,
                       .rotation = true,
                       .free_directions = false,
                       .separating = {true, true, true},
                       .contacts = true};

constexpr WorldSettings kWild{.max_speed = kBlockSpeed, .sleep = {}};

class ProjectileScene final : public WorldScene<3, OdeWorld> {
 public:
  ProjectileScene(BroadPhase<3>& broad_phase, const SceneOptions& options)
      : WorldScene(broad_phase, kNeeds, options.seed, kWild), random_(options.seed) {
    const std::uint32_t blocks = options.objects - 1;
    const std::uint32_t wide = (blocks + kLayers * kDepth - 1) / (kLayers * kDepth);
    half_width_ = kPitch * static_cast<Scalar>(std::max(wide, kDepth)) / 2;
    reach_ = half_width_ + kApron;
    add_yard(world(), reach_, kFence);
    // Out of the way until the first shot.
    ball_ = world().add_moving(Ball{kRadius}, {{{reach_ - 2, kRadius, reach_ - 2}}}, {});
    world().set_max_speed(ball_, static_cast<double>(kSpeed));
    for (std::uint32_t k = 0; k < blocks; ++k) add_block(k % kDepth, k / kDepth / wide, k / kDepth % wide);
  }

 private:
  void add_block(std::uint32_t x, std::uint32_t layer, std::uint32_t z) {
    Pose<3> pose;
    pose.position = {{(static_cast<Scalar>(x) + 0.5F - kDepth / 2.0F) * kPitch,
                      kHalfBlock + static_cast<Scalar>(layer) * kLayerPitch,
                      (static_cast<Scalar>(z) + 0.5F) * kPitch - half_width_}};
    world().add_moving(Brick<3>{{{kHalfBlock, kHalfBlock, kHalfBlock}}}, pose, {});
  }

  void act() override {
    if (step() < kFirstShot || (step() - kFirstShot) % kBetweenShots != 0) return;
    const Scalar heading = shots_++ % 2 == 0 ? 1.0F : -1.0F;
    const auto height = static_cast<Scalar>(random_.uniform(2, 5));
    const auto aside = static_cast<Scalar>(random_.uniform(-0.6, 0.6)) * half_width_;
    world().place(ball_, {{-heading * (reach_ - 2), height, aside}}, {{{heading * kSpeed, 0, 0}}, {}});
  }

  Random random_;
  Scalar half_width_ = 0;
  Scalar reach_ = 0;
  ObjectId ball_;
  std::uint32_t shots_ = 0;
};

}  // namespace

SceneEntry<3> projectile_entry() {
  return {.name = "projectile",
          .summary = "a heavy ball is shot through a stack of blocks, again every 100 steps",
          .source = "ours, for fast objects among resting ones",
          .default_objects = kDefaultObjects,
          .needs = kNeeds,
          .make = make_at_once<ProjectileScene, kDefaultObjects>,
          .grows = false,
          .parameters = "objects: the ball and the blocks of the stack, from the first step"};
}

}  // namespace kerf
