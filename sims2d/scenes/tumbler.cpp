#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/random.h"
#include "core/scene/world_scene.h"
#include "sims2d/scenes/growth.h"
#include "sims2d/scenes/rain.h"
#include "sims2d/scenes/scene_entries.h"
#include "sims2d/world.h"

namespace kerf::inline sims2d {
namespace {

constexpr std::uint32_t kDefaultObjects = 500;
constexpr Scalar kPitch = 1.7F;  ///< of the lattice in which objects begin
constexpr Scalar kHalfWall = 0.6F;
constexpr Scalar kRimSpeed = 3;    ///< units a second at a wall's middle, at most
constexpr Scalar kMaxTurn = 0.4F;  ///< radians a second

constexpr Needs kNeeds{
    .dimension = 2, .fixed_objects = false, .free_directions = false, .separating = {true, true, false}};

class TumblerScene final : public WorldScene<2, Box2dWorld> {
 public:
  TumblerScene(BroadPhase<2>& broad_phase, std::uint32_t objects, std::uint64_t seed)
      : WorldScene(broad_phase, kNeeds) {
    const auto side = static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<double>(objects))));
    const Scalar lattice = kPitch * static_cast<Scalar>(side) / 2;
    half_ = lattice + 2;
    turn_ = std::min(kMaxTurn, kRimSpeed / half_);
    for (std::uint32_t wall = 0; wall < kWalls; ++wall) walls_[wall] = world().add(wall_plan(wall));
    Random random(seed);
    for (std::uint32_t k = 0; k < objects; ++k) {
      const std::uint32_t row = k / side;
      BodyPlan plan;
      plan.shape = random_shape(random);
      plan.position = {{(static_cast<Scalar>(k % side) + 0.5F) * kPitch - lattice,
                        (static_cast<Scalar>(row) + 0.5F) * kPitch - lattice}};
      plan.spin = static_cast<Scalar>(random.uniform(-2, 2));
      world().add(plan);
    }
  }

 private:
  static constexpr std::uint32_t kWalls = 4;

  /// Where a wall is and how it moves now: all turn about the origin.
  [[nodiscard]] BodyPlan wall_plan(std::uint32_t wall) const {
    constexpr Scalar kQuarter = 1.5707963F;
    BodyPlan plan;
    plan.driven = true;
    plan.shape = Brick<2>{{{half_ + 2 * kHalfWall, kHalfWall}}};
    plan.angle =
        turn_ * Box2dWorld::kStepSeconds * static_cast<Scalar>(step()) + kQuarter * static_cast<Scalar>(wall);
    const Scalar radius = half_ + kHalfWall;
    plan.position = {{std::sin(plan.angle) * radius, -std::cos(plan.angle) * radius}};
    plan.velocity = Vector<2>{{-plan.position[1], plan.position[0]}} * turn_;
    plan.spin = turn_;
    return plan;
  }

  void act() override {
    for (std::uint32_t wall = 0; wall < kWalls; ++wall) world().place(walls_[wall], wall_plan(wall));
  }

  Scalar half_ = 0;  ///< inside of the drum
  Scalar turn_ = 0;  ///< radians a second
  std::array<ObjectId, kWalls> walls_;
};

}  // namespace

SceneEntry<2> tumbler_entry() {
  return {.name = "tumbler",
          .summary = "a square drum turns and tumbles what is in it",
          .source = "ours, after Box2D's test bed",
          .default_objects = kDefaultObjects,
          .needs = kNeeds,
          .make = make_at_once<TumblerScene, kDefaultObjects>,
          .grows = false,
          .parameters = "objects: those in the drum, from the first step; its four walls come to them"};
}

}  // namespace kerf::inline sims2d
