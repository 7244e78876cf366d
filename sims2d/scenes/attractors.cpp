#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/random.h"
#include "core/scene/attractor.h"
#include "core/scene/world_scene.h"
#include "sims2d/scenes/growth.h"
#include "sims2d/scenes/rain.h"
#include "sims2d/scenes/scene_entries.h"
#include "sims2d/world.h"

namespace kerf::inline sims2d {
namespace {

constexpr std::uint32_t kDefaultObjects = 800;
constexpr std::size_t kAttractors = 5;
constexpr std::uint32_t kStepsTogether = 200;  ///< then each cloud follows the next attractor
constexpr Scalar kPitch = 2.6F;                ///< of the lattice in which objects begin
constexpr Scalar kAttractorSpeed = 3;
constexpr Scalar kStrength = 9;  ///< drag limits the speed to 7.2: 0.29 units a step

constexpr Needs kNeeds{.dimension = 2,
                       .fixed_objects = false,
                       .free_directions = false,  // clouds are round: no direction parts them better
                       .separating = {true, true, false}};

class AttractorScene final : public WorldScene<2, Box2dWorld> {
 public:
  AttractorScene(BroadPhase<2>& broad_phase, std::uint32_t objects, std::uint64_t seed)
      : WorldScene(broad_phase, kNeeds, 0.0F) {
    Random random(seed);
    add_objects(random, objects);
    const double of_a_cloud = static_cast<double>(objects) / kAttractors;
    for (std::size_t i = 0; i < kAttractors; ++i) {
      Attractor<2> attractor = random_attractor<2>(random, room_, kAttractorSpeed);
      attractor.strength = kStrength;
      attractor.calm_radius = static_cast<Scalar>(2 + 1.3 * std::sqrt(of_a_cloud));
      attractors_.push_back(attractor);
    }
  }

 private:
  /// A lattice; `room_` becomes its box.
  void add_objects(Random& random, std::uint32_t objects) {
    const auto side = static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<double>(objects))));
    const Scalar half = kPitch * static_cast<Scalar>(side) / 2;
    room_ = {{{-half, -half}}, {{half, half}}};
    for (std::uint32_t k = 0; k < objects; ++k) {
      const std::uint32_t row = k / side;
      BodyPlan plan;
      plan.shape = random_shape(random);
      plan.position = {{(static_cast<Scalar>(k % side) + 0.5F) * kPitch - half,
                        (static_cast<Scalar>(row) + 0.5F) * kPitch - half}};
      plan.angle = static_cast<Scalar>(random.uniform(-std::numbers::pi, std::numbers::pi));
      plan.spin = static_cast<Scalar>(random.uniform(-2, 2));
      world().add(plan);
    }
  }

  /// Neighbours in the lattice begin in the same cloud.
  [[nodiscard]] std::size_t cloud_of(std::uint32_t object) const {
    return kAttractors * object / bodies().size();
  }

  void act() override {
    for (Attractor<2>& attractor : attractors_) attractor.advance(Box2dWorld::kStepSeconds, room_);
    const std::size_t turn = step() / kStepsTogether;
    for (std::uint32_t k = 0; k < bodies().size(); ++k)
      world().push(ObjectId{k}, attractors_[(cloud_of(k) + turn) % kAttractors].pull(
                                    bodies()[k].pose.position, nearness(k)));
  }

  Box<2> room_;
  std::vector<Attractor<2>> attractors_;
};

}  // namespace

SceneEntry<2> attractors_entry() {
  return {.name = "attractors",
          .summary = "clouds of objects chase five moving attractors through each other",
          .source = "paper, simulation 2, in 2D",
          .default_objects = kDefaultObjects,
          .needs = kNeeds,
          .make = make_at_once<AttractorScene, kDefaultObjects>,
          .grows = false,
          .parameters = "objects: all clouds together, from the first step"};
}

}  // namespace kerf::inline sims2d
