#include <cmath>
#include <numbers>

#include "core/base/random.h"
#include "core/scene/world_scene.h"
#include "sims2d/scenes/fixed.h"
#include "sims2d/scenes/growth.h"
#include "sims2d/scenes/scene_entries.h"
#include "sims2d/world.h"

namespace kerf::inline sims2d {
namespace {

constexpr std::uint32_t kDefaultObjects = 500;
constexpr Vector<2> kHalfRod{{2, 0.2F}};
constexpr Scalar kLengthPitch = 4.4F;  ///< of the lattice in which rods begin, along the slope
constexpr Scalar kLayerPitch = 0.6F;   ///< away from it
constexpr double kLean = 0.04;         ///< radians away from the slope, at most
constexpr Scalar kSlope = std::numbers::pi_v<Scalar> / 4;
constexpr Scalar kHalfThickness = 0.6F;

constexpr Needs kNeeds{.dimension = 2,
                       .volume = VolumeKind::oriented_box,
                       .free_directions = true,  // rods lie along the slope
                       .separating = {true, true, false}};

class RodScene final : public WorldScene<2, Box2dWorld> {
 public:
  RodScene(BroadPhase<2>& broad_phase, std::uint32_t objects, std::uint64_t seed)
      : WorldScene(broad_phase, kNeeds) {
    // So many end to end that the bed is about a third as thick as it is long.
    const auto end_to_end = static_cast<std::uint32_t>(
        std::ceil(std::sqrt(3 * static_cast<Scalar>(objects) * kLayerPitch / kLengthPitch)));
    add_valley(kLengthPitch * static_cast<Scalar>(end_to_end + 2));
    Random random(seed);
    for (std::uint32_t k = 0; k < objects; ++k) add_rod(random, k % end_to_end, k / end_to_end);
  }

 private:
  /// Two slopes that meet in the origin, in pieces as long as a rod, and posts at their upper ends.
  void add_valley(Scalar length) {
    for (const Scalar side : {-1.0F, 1.0F}) {
      const Vector<2> along{{side * std::cos(kSlope), std::sin(kSlope)}};
      const Vector<2> out{{side * std::sin(kSlope), -std::cos(kSlope)}};
      for (Scalar at = kLengthPitch / 2; at < length; at += kLengthPitch)
        world().add(fixed_brick(along * at + out * kHalfThickness, {{kLengthPitch / 2, kHalfThickness}},
                                side * kSlope));
      const Vector<2> end = along * length;
      world().add(fixed_brick({{end[0] + side * kHalfThickness, end[1] + length / 4}},
                              {{kHalfThickness, length / 4}}));
    }
  }

  /// Rod `place` of its layer, counted upwards along the right slope.
  void add_rod(Random& random, std::uint32_t place, std::uint32_t layer) {
    const Scalar away = kHalfRod[1] + 0.3F + kLayerPitch * static_cast<Scalar>(layer);
    const Scalar at = kLengthPitch * (static_cast<Scalar>(place) + 0.7F);
    BodyPlan plan;
    plan.shape = Brick<2>{kHalfRod};
    plan.position = {
        {at * std::cos(kSlope) - away * std::sin(kSlope), at * std::sin(kSlope) + away * std::cos(kSlope)}};
    plan.angle = kSlope + static_cast<Scalar>(random.uniform(-kLean, kLean));
    world().add(plan);
  }

  void act() override {}
};

}  // namespace

SceneEntry<2> rods_entry() {
  return {.name = "rods",
          .summary = "parallel rods slide down a slope that lies along no axis",
          .source = "ours, for free directions",
          .default_objects = kDefaultObjects,
          .needs = kNeeds,
          .make = make_at_once<RodScene, kDefaultObjects>,
          .grows = false,
          .parameters = "objects: rods, from the first step"};
}

}  // namespace kerf::inline sims2d
