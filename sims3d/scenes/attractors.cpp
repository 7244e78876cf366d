#include <cmath>
#include <vector>

#include "core/base/random.h"
#include "core/scene/attractor.h"
#include "core/scene/world_scene.h"
#include "sims3d/scenes/drop_scene.h"
#include "sims3d/scenes/random_body.h"
#include "sims3d/scenes/scene_entries.h"
#include "sims3d/world.h"

namespace kerf {
namespace {

constexpr std::uint32_t kDefaultObjects = 800;
constexpr std::size_t kAttractors = 5;
constexpr std::uint32_t kStepsTogether = 200;  // then each cloud follows the next attractor
constexpr Scalar kPitch = 2.4F;                // of the lattice in which objects begin
constexpr double kJitter = 0.1;
constexpr Scalar kAttractorSpeed = 3;
constexpr Scalar kStrength = 14;
constexpr double kSpin = 3;

constexpr Needs kNeeds{.dimension = 3,
                       .volume = VolumeKind::box,
                       .fixed_objects = false,
                       .rotation = true,
                       .free_directions = false,  // clouds are round: no direction parts them better
                       .separating = {true, true, true},
                       .contacts = true};

constexpr WorldSettings kWeightless{.gravity = 0, .sleep = {.allowed = false}};

class AttractorScene final : public WorldScene<3, OdeWorld> {
 public:
  AttractorScene(BroadPhase<3>& broad_phase, const SceneOptions& options)
      : WorldScene(broad_phase, kNeeds, options.seed, kWeightless) {
    Random random(options.seed);
    add_objects(random, options.objects);
    const double of_a_cloud = static_cast<double>(options.objects) / kAttractors;
    for (std::size_t i = 0; i < kAttractors; ++i) {
      Attractor<3> attractor = random_attractor<3>(random, room_, kAttractorSpeed);
      attractor.strength = kStrength;
      attractor.calm_radius = static_cast<Scalar>(2 + 1.3 * std::cbrt(of_a_cloud));
      attractors_.push_back(attractor);
    }
  }

 private:
  /// A lattice; `room_` becomes its box.
  void add_objects(Random& random, std::uint32_t objects) {
    const auto side = static_cast<std::uint32_t>(std::ceil(std::cbrt(static_cast<double>(objects))));
    const Scalar half = kPitch * static_cast<Scalar>(side) / 2;
    room_ = {{{-half, -half, -half}}, {{half, half, half}}};
    for (std::uint32_t k = 0; k < objects; ++k) {
      const std::array<std::uint32_t, 3> cell{k % side, k / side % side, k / side / side};
      Pose<3> pose;
      for (int i = 0; i < 3; ++i)
        pose.position[i] = (static_cast<Scalar>(cell[static_cast<std::size_t>(i)]) + 0.5F) * kPitch - half;
      pose.position = pose.position + random_vector(random, kJitter);
      pose.axes = random_turn(random);
      const Shape<3> shape = random_shape(random);
      world().add_moving(shape, pose, {{}, random_vector(random, kSpin)});
    }
  }

  /// Neighbours in the lattice begin in the same cloud.
  [[nodiscard]] std::size_t cloud_of(std::uint32_t object) const {
    return kAttractors * object / bodies().size();
  }

  void act() override {
    for (Attractor<3>& attractor : attractors_) attractor.advance(kStepSeconds, room_);
    const std::size_t turn = step() / kStepsTogether;
    for (std::uint32_t k = 0; k < bodies().size(); ++k)
      world().push(
          {k}, attractors_[(cloud_of(k) + turn) % kAttractors].pull(bodies()[k].pose.position, nearness(k)));
  }

  static constexpr Scalar kStepSeconds = 0.04F;
  Box<3> room_;
  std::vector<Attractor<3>> attractors_;
};

}  // namespace

SceneEntry<3> attractors_entry() {
  return {.name = "attractors",
          .summary = "clouds of objects chase five moving attractors through each other",
          .source = "the paper's simulation 2",
          .default_objects = kDefaultObjects,
          .needs = kNeeds,
          .make = make_at_once<AttractorScene, kDefaultObjects>,
          .grows = false,
          .parameters = "objects: all clouds together, from the first step"};
}

}  // namespace kerf
