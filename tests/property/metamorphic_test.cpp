// The same moving scene with other ids, seen in a mirror, with its axes permuted or at another scale has the
// same pairs. The tree that finds them is another one each time.

#include <gtest/gtest.h>

#include <numeric>

#include "core/bsp/bsp.h"
#include "core/scene/bounding.h"
#include "tests/property/symmetry.h"
#include "tests/property/turn.h"
#include "tests/support/boxes.h"
#include "tests/support/checked.h"
#include "tests/support/config_of.h"
#include "tests/support/dimensions.h"

namespace kerf::test {
namespace {

constexpr std::uint32_t kObjects = 120;
constexpr std::uint32_t kSteps = 24;

/// The volumes of a scene, step by step: bricks and balls that wander and turn. Half of them keep to a grid,
/// where many touch exactly.
template <int D>
class MovingScene {
 public:
  MovingScene(VolumeKind kind, std::uint64_t seed) : kind_(kind), random_(seed) {
    for (std::uint32_t i = 0; i < kObjects; ++i) {
      Member member;
      member.pose.position = random_point<D>(random_, -5, 5);
      for (int k = 0; k < D; ++k) member.brick.half[k] = static_cast<Scalar>(1 + random_.below(3)) / 4;
      member.is_ball = i % 3 == 0;
      member.on_grid = i % 2 == 0;
      members_.push_back(member);
    }
  }

  std::vector<Volume<D>> next() {
    std::vector<Volume<D>> volumes;
    for (Member& member : members_) {
      member.pose.position = member.pose.position + random_point<D>(random_, -0.4, 0.4);
      if (!member.on_grid) member.pose.axes = turned<D>(identity_axes<D>(), random_.uniform(0, 6), random_);
      Pose<D> shown = member.pose;
      if (member.on_grid)
        for (Scalar& x : shown.position.value) x = std::round(x * 4) / 4;
      Shape<D> shape = member.brick;
      if (member.is_ball) shape = Ball{member.brick.half[0]};
      volumes.push_back(bound<D>(kind_, shape, precise(shown)));
    }
    return volumes;
  }

 private:
  struct Member {
    Pose<D> pose;
    Brick<D> brick;
    bool is_ball = false;
    bool on_grid = false;
  };

  VolumeKind kind_;
  Random random_;
  std::vector<Member> members_;
};

Config busy_config() {
  return config_of(
      "max_redundancy=0.4,schedule_interval=1,budget_divisor=1,min_threshold=4,max_threshold=8,directions="
      "32");
}

/// The pairs of each step, with the ids of the scene, when every volume is changed and object i is called
/// `names[i]`.
template <int D>
std::vector<std::vector<Pair>> pairs_of(VolumeKind kind, const Symmetry<D>& change,
                                        const std::vector<std::uint32_t>& names) {
  MovingScene<D> scene(kind, 77);
  Bsp<D> tree(busy_config(), kind);
  Checked<D> checked(tree);
  std::vector<std::uint32_t> meaning(names.size());
  for (std::uint32_t i = 0; i < names.size(); ++i) meaning[names[i]] = i;
  std::vector<std::vector<Pair>> steps;
  for (std::uint32_t step = 0; step < kSteps; ++step) {
    const std::vector<Volume<D>> volumes = scene.next();
    for (std::uint32_t i = 0; i < kObjects; ++i) {
      const Volume<D> volume = change.applied(volumes[i]);
      const Mobility mobility = i % 10 == 0 ? Mobility::fixed : Mobility::moving;
      EXPECT_EQ(step == 0 ? checked.insert({names[i]}, volume, mobility) : checked.move({names[i]}, volume),
                Status::ok);
    }
    checked.step();
    std::vector<Pair> pairs;
    for (const Pair& pair : checked.pairs())
      pairs.push_back(kerf::make_pair({meaning[pair.a.index()]}, {meaning[pair.b.index()]}));
    steps.push_back(sorted(pairs));
  }
  return steps;
}

std::vector<std::uint32_t> own_names() {
  std::vector<std::uint32_t> names(kObjects);
  std::iota(names.begin(), names.end(), 0);
  return names;
}

template <class T>
class Metamorphic : public testing::Test {
 protected:
  static constexpr int kD = T::value;

  void expect_same_pairs(const Symmetry<kD>& change, const std::vector<std::uint32_t>& names = own_names()) {
    for (const VolumeKind kind : volume_kinds<kD>()) {
      SCOPED_TRACE(to_string(kind));
      const auto plain = pairs_of<kD>(kind, Symmetry<kD>::none(), own_names());
      const auto changed = pairs_of<kD>(kind, change, names);
      for (std::uint32_t step = 0; step < kSteps; ++step) {
        EXPECT_GT(plain[step].size(), 20U);
        EXPECT_TRUE(same_pairs(changed[step], plain[step])) << "in step " << step;
      }
    }
  }
};
TYPED_TEST_SUITE(Metamorphic, Dimensions, DimensionNames);

TYPED_TEST(Metamorphic, PermutedIdsChangeNothing) {
  std::vector<std::uint32_t> names = own_names();
  Random random(5);
  for (std::uint32_t i = kObjects - 1; i > 0; --i) std::swap(names[i], names[random.below(i + 1)]);
  this->expect_same_pairs(Symmetry<TypeParam::value>::none(), names);
}

TYPED_TEST(Metamorphic, MirroredAxesChangeNothing) {
  constexpr std::size_t kAxes = TypeParam::value;
  for (std::size_t mirrored = 0; mirrored <= kAxes; ++mirrored) {  // each axis, then all
    auto change = Symmetry<TypeParam::value>::none();
    for (std::size_t axis = 0; axis < kAxes; ++axis)
      change.flip[axis] = mirrored == kAxes || axis == mirrored;
    this->expect_same_pairs(change);
  }
}

TYPED_TEST(Metamorphic, SwappedAxesChangeNothing) {
  constexpr int kAxes = TypeParam::value;
  for (int first = 0; first < kAxes - 1; ++first) {
    auto change = Symmetry<kAxes>::none();
    std::swap(change.from[static_cast<std::size_t>(first)], change.from[static_cast<std::size_t>(first) + 1]);
    this->expect_same_pairs(change);
  }
}

TYPED_TEST(Metamorphic, PowersOfTwoChangeNothing) {
  for (const int exponent : {-60, -1, 1, 20, 100}) {
    auto change = Symmetry<TypeParam::value>::none();
    change.exponent = exponent;
    this->expect_same_pairs(change);
  }
}

}  // namespace
}  // namespace kerf::test
