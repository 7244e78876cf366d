#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/scene/world_scene.h"
#include "sims3d/scenes/drop_scene.h"
#include "sims3d/scenes/random_body.h"
#include "sims3d/scenes/scene_entries.h"
#include "sims3d/scenes/yard.h"
#include "sims3d/world.h"

namespace kerf {
namespace {

constexpr std::uint32_t kDefaultObjects = 600;
constexpr Vector<3> kHalfRod{{2.5F, 0.18F, 0.18F}};
constexpr Scalar kLengthPitch = 5.4F;  // of the lattice in which rods begin
constexpr Scalar kSidePitch = 0.6F;
constexpr Scalar kLayerPitch = 1.2F;
constexpr std::uint32_t kRows = 3;  // rods end to end
constexpr std::uint32_t kLayers = 12;
constexpr Scalar kLowest = 0.5F;
constexpr double kLean = 0.06;  // of a rod away from the diagonal: the tangent of the angle at most
constexpr Scalar kFence = 2;
constexpr Scalar kApron = 8;  // floor beyond the outermost rods

constexpr Needs kNeeds{.dimension = 3,
                       .volume = VolumeKind::oriented_box,
                       .fixed_objects = true,
                       .rotation = true,
                       .free_directions = true,  // all rods lie along a diagonal
                       .separating = {true, false, true},
                       .contacts = true};

/// Axes of a body that lies flat, its first axis along (1, lean) in the frame of the diagonal.
std::array<Vector<3>, 3> lying(double lean) {
  const double x = 1 - lean;
  const double z = 1 + lean;
  const double norm = std::sqrt(x * x + z * z);
  const auto c = static_cast<Scalar>(x / norm);
  const auto s = static_cast<Scalar>(z / norm);
  return {Vector<3>{{c, 0, s}}, Vector<3>{{0, 1, 0}}, Vector<3>{{-s, 0, c}}};
}

class RodScene final : public WorldScene<3, OdeWorld> {
 public:
  RodScene(BroadPhase<3>& broad_phase, const SceneOptions& options)
      : WorldScene(broad_phase, kNeeds, options.seed) {
    const std::uint32_t abreast = std::max(1U, (options.objects + kRows * kLayers - 1) / (kRows * kLayers));
    const Scalar length = kLengthPitch * kRows;
    const Scalar width = kSidePitch * static_cast<Scalar>(abreast);
    add_yard(world(), std::sqrt(0.125F) * (length + width) + kApron, kFence);
    Random random(options.seed);
    const std::array<Vector<3>, 3> frame = lying(0);
    for (std::uint32_t k = 0; k < options.objects; ++k) {
      const auto row = static_cast<Scalar>(k / abreast % kRows);
      const auto side = static_cast<Scalar>(k % abreast);
      const std::uint32_t layer = k / abreast / kRows;
      Pose<3> pose;
      pose.position = frame[0] * ((row + 0.5F) * kLengthPitch - length / 2) +
                      frame[2] * ((side + 0.5F) * kSidePitch - width / 2);
      pose.position[1] = kLowest + static_cast<Scalar>(layer) * kLayerPitch;
      pose.axes = lying(random.uniform(-kLean, kLean));
      world().add_moving(Brick<3>{kHalfRod}, pose, {});
    }
  }

 private:
  void act() override {}
};

}  // namespace

SceneEntry<3> rods_entry() {
  return {.name = "rods",
          .summary = "parallel rods fall into a bed of logs that lies along no axis",
          .source = "ours, for free directions",
          .default_objects = kDefaultObjects,
          .needs = kNeeds,
          .make = make_at_once<RodScene, kDefaultObjects>,
          .grows = false,
          .parameters = "objects: rods, from the first step, in twelve layers"};
}

}  // namespace kerf
