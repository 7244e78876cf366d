#include <algorithm>
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

constexpr std::uint32_t kDefaultObjects = 810;
constexpr std::uint32_t kAcross = 3;  // fragments along each side of a block
constexpr std::uint32_t kFragments = kAcross * kAcross * kAcross;
constexpr Scalar kCell = 1;              // of a fragment and its share of the gaps
constexpr Scalar kHalfFragment = 0.48F;  // fragments of a block do not touch when they part
constexpr Scalar kHalfBlock = kCell * kAcross / 2;
constexpr Scalar kPitch = 8;  // of the lattice in which blocks begin
constexpr double kJitter = 0.6;
constexpr double kSpin = 0.4;
constexpr Scalar kBurst = 1.5F;  // speed at which a fragment flies off, for each unit from the block's middle
constexpr Scalar kSpread = 3;
constexpr Scalar kStrength = 6;

constexpr Needs kNeeds{.dimension = 3,
                       .volume = VolumeKind::box,
                       .fixed_objects = false,
                       .rotation = true,
                       .free_directions = false,
                       .separating = {true, true, true},
                       .contacts = true};

constexpr WorldSettings kWeightless{.gravity = 0, .sleep = {.allowed = false}};

Vector<3> cross(const Vector<3>& a, const Vector<3>& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

Shape<3> cube(Scalar half) { return Brick<3>{{{half, half, half}}}; }

class FractureScene final : public WorldScene<3, OdeWorld> {
 public:
  FractureScene(BroadPhase<3>& broad_phase, const SceneOptions& options)
      : WorldScene(broad_phase, kNeeds, options.seed, kWeightless) {
    Random random(options.seed);
    const std::uint32_t blocks = std::max(1U, options.objects / kFragments);
    const auto side = static_cast<std::uint32_t>(std::ceil(std::cbrt(blocks)));
    const Scalar half = kPitch * static_cast<Scalar>(side) / 2;
    for (std::uint32_t k = 0; k < blocks; ++k)
      add_block(random, {k % side, k / side % side, k / side / side}, half);
    whole_.assign(blocks, 1);
    attractor_.strength = kStrength;
    attractor_.calm_radius = 0.5F * static_cast<Scalar>(std::cbrt(static_cast<double>(blocks) * kFragments));
  }

 private:
  void add_block(Random& random, const std::array<std::uint32_t, 3>& cell, Scalar half) {
    Pose<3> pose;
    for (int i = 0; i < 3; ++i)
      pose.position[i] = (static_cast<Scalar>(cell[static_cast<std::size_t>(i)]) + 0.5F) * kPitch - half;
    pose.position = pose.position + random_vector(random, kJitter);
    pose.axes = random_turn(random);
    world().add_moving(cube(kHalfBlock), pose, {{}, random_vector(random, kSpin)});
  }

  void act() override {
    const std::vector<Pair> hits(contacts().begin(), contacts().end());
    for (const Pair& hit : hits)
      for (const ObjectId object : {hit.a, hit.b})
        if (object.index() < whole_.size() && whole_[object.index()] != 0) break_up(object);
    for (std::uint32_t k = 0; k < bodies().size(); ++k)
      world().push({k}, attractor_.pull(bodies()[k].pose.position, distance_of(k)));
  }

  /// In calm radii: fragments spread into a cloud that is wider than the place where blocks meet.
  [[nodiscard]] Scalar distance_of(std::uint32_t object) const {
    const bool whole = object < whole_.size() && whole_[object] != 0;
    return whole ? 1 : kSpread * nearness(object);
  }

  /// The fragments stand where the block was and move as it did, and a little apart.
  void break_up(ObjectId block) {
    whole_[block.index()] = 0;
    const Pose<3> pose = bodies()[block.index()].pose;
    const Twist motion = world().twist_of(block);
    world().reshape(block, cube(kHalfFragment));
    for (std::uint32_t k = 0; k < kFragments; ++k) {
      const std::array<std::uint32_t, 3> cell{k % kAcross, k / kAcross % kAcross, k / kAcross / kAcross};
      Vector<3> arm;
      for (std::size_t i = 0; i < 3; ++i)
        arm = arm + pose.axes[i] * ((static_cast<Scalar>(cell[i]) - (kAcross - 1) / 2.0F) * kCell);
      const Pose<3> place{pose.position + arm, pose.axes};
      const Twist own{motion.linear + cross(motion.angular, arm) + arm * kBurst, motion.angular};
      if (k == 0) {
        world().place(block, place.position, own);
      } else {
        world().add_moving(cube(kHalfFragment), place, own);
      }
    }
  }

  Attractor<3> attractor_;
  std::vector<std::uint8_t> whole_;  // by block; blocks are the first objects
};

}  // namespace

SceneEntry<3> fracture_entry() {
  return {.name = "fracture",
          .summary = "building blocks fall together and break into many smaller ones when they are hit",
          .source = "the paper's simulation 3",
          .default_objects = kDefaultObjects,
          .needs = kNeeds,
          .make = make_at_once<FractureScene, kDefaultObjects>,
          .grows = false,
          .parameters = "objects: fragments when all is broken, rounded down to whole blocks of 27"};
}

}  // namespace kerf
