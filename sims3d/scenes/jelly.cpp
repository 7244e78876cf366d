#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/random.h"
#include "core/scene/world_scene.h"
#include "sims3d/scenes/drop_scene.h"
#include "sims3d/scenes/random_body.h"
#include "sims3d/scenes/scene_entries.h"
#include "sims3d/scenes/yard.h"
#include "sims3d/world.h"

namespace kerf {
namespace {

constexpr std::uint32_t kDefaultObjects = 400;
constexpr std::uint32_t kLayers = 5;
constexpr Scalar kPitch = 1.8F;  // of the lattice in which blocks begin
constexpr Scalar kLowest = 2;
constexpr double kJitter = 0.15;
constexpr double kSpin = 3;
constexpr double kMinHalf = 0.42;
constexpr double kMaxHalf = 0.58;
constexpr Scalar kFence = 4;

// Of the springs, with the step as the unit of time.
constexpr Scalar kStiffness = 0.35F;
constexpr Scalar kDamping = 0.12F;
constexpr Scalar kKnock = 0.02F;  // strain speed for each unit a second by which the block's speed changes
constexpr Scalar kMaxStrain = 0.3F;
constexpr Scalar kBreath = 0.04F;     // strain of the breathing
constexpr Scalar kBreathTurn = 0.2F;  // radians a step, about

constexpr Needs kNeeds{.dimension = 3,
                       .volume = VolumeKind::box,
                       .fixed_objects = true,
                       .rotation = true,
                       .free_directions = false,
                       .separating = {true, true, true},
                       .contacts = true};

/// The deformation of a block along its own axes.
struct Softness {
  Vector<3> half;  ///< at rest
  Vector<3> strain;
  Vector<3> strain_speed;
  Vector<3> velocity;  ///< of the block, a step ago
  Vector<2> breath;    ///< a point on a circle of radius `kBreath`
};

constexpr WorldSettings kSleepless{.sleep = {.allowed = false}};

/// A turn by the angle whose half has this tangent: exact on the circle, without a library's sine.
Vector<2> turned(const Vector<2>& point, Scalar half_tangent) {
  const Scalar norm = 1 + half_tangent * half_tangent;
  const Scalar c = (1 - half_tangent * half_tangent) / norm;
  const Scalar s = 2 * half_tangent / norm;
  return {{c * point[0] - s * point[1], s * point[0] + c * point[1]}};
}

void knock(Softness& soft, const Pose<3>& pose, const Vector<3>& velocity) {
  const Vector<3> change = velocity - soft.velocity;
  soft.velocity = velocity;
  for (int i = 0; i < 3; ++i) {
    const Scalar hit = std::abs(dot(change, pose.axes[static_cast<std::size_t>(i)]));
    soft.strain_speed[i] -= kKnock * hit + kStiffness * soft.strain[i] + kDamping * soft.strain_speed[i];
    soft.strain[i] = std::clamp(soft.strain[i] + soft.strain_speed[i], -kMaxStrain, kMaxStrain);
  }
  soft.breath = turned(soft.breath, kBreathTurn / 2);
}

/// The block's extents now; their product is that at rest.
Brick<3> deformed(const Softness& soft) {
  Vector<3> stretch{{1 + soft.breath[0], 1 + soft.breath[1], 1}};
  for (int i = 0; i < 3; ++i) stretch[i] += soft.strain[i];
  const Scalar even = std::cbrt(stretch[0] * stretch[1] * stretch[2]);
  Brick<3> brick{soft.half};
  for (int i = 0; i < 3; ++i) brick.half[i] *= stretch[i] / even;
  return brick;
}

class JellyScene final : public WorldScene<3, OdeWorld> {
 public:
  JellyScene(BroadPhase<3>& broad_phase, const SceneOptions& options)
      : WorldScene(broad_phase, kNeeds, options.seed, kSleepless) {
    const double a_layer = static_cast<double>(options.objects) / kLayers;
    const auto side = std::max(2U, static_cast<std::uint32_t>(std::ceil(std::sqrt(a_layer))));
    const Scalar half = kPitch * static_cast<Scalar>(side) / 2;
    add_yard(world(), half, kFence);
    first_ = static_cast<std::uint32_t>(bodies().size());
    Random random(options.seed);
    for (std::uint32_t k = 0; k < options.objects; ++k) {
      const std::uint32_t layer = k / side / side;
      Pose<3> pose;
      pose.position = {{(static_cast<Scalar>(k % side) + 0.5F) * kPitch - half,
                        kLowest + static_cast<Scalar>(layer) * kPitch,
                        (static_cast<Scalar>(k / side % side) + 0.5F) * kPitch - half}};
      pose.position = pose.position + random_vector(random, kJitter);
      pose.axes = random_turn(random);
      add_block(random, pose);
    }
  }

 private:
  void add_block(Random& random, const Pose<3>& pose) {
    Softness soft;
    for (int i = 0; i < 3; ++i) soft.half[i] = static_cast<Scalar>(random.uniform(kMinHalf, kMaxHalf));
    soft.breath = turned({{kBreath, 0}}, static_cast<Scalar>(random.uniform(-4, 4)));
    world().add_moving(deformed(soft), pose, {{}, random_vector(random, kSpin)});
    blocks_.push_back(soft);
  }

  void act() override {
    for (std::uint32_t k = 0; k < blocks_.size(); ++k) {
      const ObjectId object{first_ + k};
      knock(blocks_[k], bodies()[object.index()].pose, world().twist_of(object).linear);
      world().reshape(object, deformed(blocks_[k]));
    }
  }

  std::uint32_t first_ = 0;
  std::vector<Softness> blocks_;
};

}  // namespace

SceneEntry<3> jelly_entry() {
  return {.name = "jelly",
          .summary = "soft blocks fall into a basin, breathe and wobble: every box changes in every step",
          .source = "ours, after section 7 of the paper",
          .default_objects = kDefaultObjects,
          .needs = kNeeds,
          .make = make_at_once<JellyScene, kDefaultObjects>,
          .grows = false,
          .parameters = "objects: soft blocks, from the first step"};
}

}  // namespace kerf
