#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/random.h"
#include "core/scene/attractor.h"
#include "core/scene/world_scene.h"
#include "sims2d/scenes/growth.h"
#include "sims2d/scenes/scene_entries.h"
#include "sims2d/world.h"

namespace kerf::inline sims2d {
namespace {

constexpr std::uint32_t kDefaultObjects = 800;
constexpr std::uint32_t kAcross = 4;  ///< fragments along each side of a block
constexpr std::uint32_t kFragments = kAcross * kAcross;
constexpr Scalar kCell = 1;              ///< of a fragment and its share of the gaps
constexpr Scalar kHalfFragment = 0.45F;  ///< fragments of a block do not touch when they part
constexpr Scalar kHalfBlock = kCell * kAcross / 2;
constexpr Scalar kPitch = 9;  ///< of the lattice in which blocks begin
constexpr double kJitter = 1;
constexpr double kSpin = 0.5;
constexpr Scalar kBurst = 1;  ///< speed at which a fragment flies off, for each unit from the block's middle
constexpr Scalar kSpread = 3;
constexpr Scalar kStrength = 8;

constexpr Needs kNeeds{
    .dimension = 2, .fixed_objects = false, .free_directions = false, .separating = {true, true, false}};

Shape<2> square(Scalar half) { return Brick<2>{{{half, half}}}; }

class FractureScene final : public WorldScene<2, Box2dWorld> {
 public:
  FractureScene(BroadPhase<2>& broad_phase, std::uint32_t objects, std::uint64_t seed)
      : WorldScene(broad_phase, kNeeds, 0.0F) {
    Random random(seed);
    const std::uint32_t blocks = std::max(1U, objects / kFragments);
    const auto side = static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<double>(blocks))));
    const Scalar half = kPitch * static_cast<Scalar>(side) / 2;
    for (std::uint32_t k = 0; k < blocks; ++k) {
      const std::uint32_t row = k / side;
      BodyPlan plan;
      plan.shape = square(kHalfBlock);
      plan.position = {{(static_cast<Scalar>(k % side) + 0.5F) * kPitch - half,
                        (static_cast<Scalar>(row) + 0.5F) * kPitch - half}};
      for (int i = 0; i < 2; ++i) plan.position[i] += static_cast<Scalar>(random.uniform(-kJitter, kJitter));
      plan.angle = static_cast<Scalar>(random.uniform(-std::numbers::pi, std::numbers::pi));
      plan.spin = static_cast<Scalar>(random.uniform(-kSpin, kSpin));
      world().add(plan);
    }
    whole_.assign(blocks, 1);
    attractor_.strength = kStrength;
    attractor_.calm_radius = 0.4F * std::sqrt(static_cast<Scalar>(blocks * kFragments));
  }

 private:
  void act() override {
    const std::vector<Pair> hits(contacts().begin(), contacts().end());
    for (const Pair& hit : hits)
      for (const ObjectId object : {hit.a, hit.b})
        if (object.index() < whole_.size() && whole_[object.index()] != 0) break_up(object);
    for (std::uint32_t k = 0; k < bodies().size(); ++k)
      world().push(ObjectId{k}, attractor_.pull(bodies()[k].pose.position, distance_of(k)));
  }

  /// In calm radii: fragments spread into a cloud that is wider than the place where blocks meet.
  [[nodiscard]] Scalar distance_of(std::uint32_t object) const {
    const bool whole = object < whole_.size() && whole_[object] != 0;
    return whole ? 1 : kSpread * nearness(object);
  }

  /// The fragments stand where the block was and move as it did, and a little apart.
  void break_up(ObjectId block) {
    whole_[block.index()] = 0;
    const Pose<2> pose = bodies()[block.index()].pose;
    const Vector<2> velocity = world().velocity_of(block);
    BodyPlan plan;
    plan.shape = square(kHalfFragment);
    plan.angle = std::atan2(pose.axes[0][1], pose.axes[0][0]);
    plan.spin = world().spin_of(block);
    world().reshape(block, plan.shape);
    for (std::uint32_t k = 0; k < kFragments; ++k) {
      const auto cell = [](std::uint32_t i) {
        return (static_cast<Scalar>(i) - (kAcross - 1) / 2.0F) * kCell;
      };
      const Vector<2> arm = pose.axes[0] * cell(k % kAcross) + pose.axes[1] * cell(k / kAcross);
      plan.position = pose.position + arm;
      plan.velocity = velocity + Vector<2>{{-arm[1], arm[0]}} * plan.spin + arm * kBurst;
      if (k == 0) {
        world().place(block, plan);
      } else {
        world().add(plan);
      }
    }
  }

  Attractor<2> attractor_;
  std::vector<std::uint8_t> whole_;  ///< by block; blocks are the first objects
};

}  // namespace

SceneEntry<2> fracture_entry() {
  return {.name = "fracture",
          .summary = "building blocks fall together and break into many smaller ones when they are hit",
          .source = "paper, simulation 3, in 2D",
          .default_objects = kDefaultObjects,
          .needs = kNeeds,
          .make = make_at_once<FractureScene, kDefaultObjects>,
          .grows = false,
          .parameters = "objects: fragments when all is broken, rounded down to whole blocks of 16"};
}

}  // namespace kerf::inline sims2d
