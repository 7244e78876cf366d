#include "sims3d/scenes/scenes.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <ostream>
#include <set>

#include "core/base/overloaded.h"
#include "core/broad_phase/brute_force.h"
#include "core/bsp/bsp.h"
#include "sims3d/scenes/drop_scene.h"
#include "tests/sims3d/test_broad_phases.h"

namespace kerf {

/// How GoogleTest prints the scene that a test is about.
void PrintTo(const SceneEntry<3>& entry, std::ostream* stream) { *stream << entry.name; }

namespace {

using sims3d_test::Everything;
using sims3d_test::Seam;
using sims3d_test::Silent;
using testing::IsEmpty;

constexpr SceneOptions kSmall{.objects = 250, .steps = 120, .seed = 1};

class Scenes : public testing::TestWithParam<SceneEntry<3>> {
 protected:
  static std::unique_ptr<Scene<3>> make(BroadPhase<3>& broad_phase, const SceneOptions& options) {
    return GetParam().make(broad_phase, options);
  }
};

std::vector<Vector<3>> positions(const Scene<3>& scene) {
  std::vector<Vector<3>> list;
  for (const Body<3>& body : scene.bodies()) list.push_back(body.pose.position);
  return list;
}

std::vector<Pair> sorted(std::span<const Pair> pairs) {
  std::vector<Pair> list(pairs.begin(), pairs.end());
  std::sort(list.begin(), list.end());
  return list;
}

std::vector<Pair> oracle_pairs(const Scene<3>& scene) {
  BruteForce<3> oracle;
  for (std::uint32_t i = 0; i < scene.bodies().size(); ++i)
    EXPECT_EQ(oracle.insert({i}, scene.bodies()[i].box, scene.bodies()[i].mobility), Status::ok);
  oracle.step();
  return sorted(oracle.pairs());
}

std::size_t moving(const Scene<3>& scene) {
  return static_cast<std::size_t>(
      std::count_if(scene.bodies().begin(), scene.bodies().end(),
                    [](const Body<3>& body) { return body.mobility == Mobility::moving; }));
}

void advance(Scene<3>& scene, int steps) {
  for (int i = 0; i < steps; ++i) scene.advance();
}

/// The points of the shape that reach furthest, in the world.
std::vector<Vector<3>> extremes(const Body<3>& body) {
  std::vector<Vector<3>> points;
  const auto of_ball = [&](const Ball& ball) {
    for (int axis = 0; axis < 3; ++axis)
      for (const Scalar sign : {-1.0F, 1.0F})
        points.push_back(body.pose.position + axis_vector<3>(axis) * (sign * ball.radius));
  };
  const auto of_brick = [&](const Brick<3>& brick) {
    for (int corner = 0; corner < 8; ++corner) {
      Vector<3> point = body.pose.position;
      for (int axis = 0; axis < 3; ++axis) {
        const Scalar sign = ((corner >> axis) & 1) != 0 ? 1.0F : -1.0F;
        point = point + body.pose.axes[static_cast<std::size_t>(axis)] * (sign * brick.half[axis]);
      }
      points.push_back(point);
    }
  };
  const auto of_surface = [&](const std::shared_ptr<const Surface>& surface) {
    for (const Vector<3>& vertex : surface->vertices) points.push_back(body.pose.position + vertex);
  };
  std::visit(Overloaded{of_ball, of_brick, of_surface}, body.shape);
  return points;
}

/// What the rounding of poses and of this test's own sums can move a point by.
Box<3> widened(Box<3> box) {
  for (int axis = 0; axis < 3; ++axis) {
    box.min[axis] -= 1e-4F;
    box.max[axis] += 1e-4F;
  }
  return box;
}

TEST_P(Scenes, NoContactIsOutsideTheTreesPairs) {
  Bsp<3> tree;
  Everything everything;
  const SceneOptions few{.objects = 80, .steps = 20, .seed = 3};
  const auto scene = make(tree, few);
  const auto reference = make(everything, few);
  for (int i = 0; i < 80; ++i) {
    scene->advance();
    reference->advance();
    ASSERT_EQ(sorted(scene->contacts()), sorted(reference->contacts())) << "step " << scene->step();
  }
  EXPECT_EQ(positions(*scene), positions(*reference));
}

TEST_P(Scenes, AnotherSeedDropsOtherObjectsElsewhere) {
  const auto first_drop = [](std::uint64_t seed) {
    BruteForce<3> broad_phase;
    const auto scene = make(broad_phase, {.objects = 1, .steps = 1, .seed = seed});
    scene->advance();
    return scene->bodies().back();
  };
  EXPECT_EQ(first_drop(1).pose.position, first_drop(1).pose.position);
  EXPECT_NE(first_drop(1).pose.position, first_drop(2).pose.position);
  EXPECT_NE(first_drop(1).box.extent(), first_drop(2).box.extent());
}

TEST_P(Scenes, GrowsToTheNumberAskedAndNothingLeaves) {
  Bsp<3> tree;
  const auto scene = make(tree, {.objects = 700, .steps = 200, .seed = 2});
  advance(*scene, 100);
  EXPECT_EQ(moving(*scene), 350U);
  advance(*scene, 300);
  EXPECT_EQ(moving(*scene), 700U);
  EXPECT_EQ(static_cast<const DropScene&>(*scene).put_back(), 0U);
}

TEST_P(Scenes, CarriesThePapersNumberOfObjects) {
  Bsp<3> tree;
  const auto scene = make(tree, {.objects = 4250, .steps = 150, .seed = 1});
  for (int i = 0; i < 4; ++i) {
    advance(*scene, 50);
    ASSERT_EQ(sorted(scene->pairs()), oracle_pairs(*scene)) << "step " << scene->step();
  }
  EXPECT_EQ(moving(*scene), 4250U);
  EXPECT_EQ(static_cast<const DropScene&>(*scene).put_back(), 0U);
  EXPECT_GT(scene->contacts().size(), 4250U);
}

TEST_P(Scenes, LetsTheTreeSplitAndRepairItself) {
  Bsp<3> tree;
  const auto scene = make(tree, {});
  advance(*scene, 500);
  const Statistics statistics = tree.statistics();
  EXPECT_GE(statistics.leaves, 6U);
  EXPECT_GT(statistics.count(Operator::split), 0U);
  EXPECT_GT(statistics.count(Operator::shift_split), 0U);
  EXPECT_GT(statistics.count(Operator::balance), 0U);
  EXPECT_GT(statistics.count(Operator::swap), 0U);
}

TEST_P(Scenes, ComesToRest) {
  Bsp<3> tree;
  const auto scene = make(tree, kSmall);
  advance(*scene, 600);
  const std::vector<Vector<3>> before = positions(*scene);
  advance(*scene, 25);
  std::size_t restless = 0;
  for (std::size_t i = 0; i < before.size(); ++i)
    restless += length(positions(*scene)[i] - before[i]) > 0.1F ? 1U : 0U;
  EXPECT_LE(restless, 5U);
}

TEST_P(Scenes, BoxesHoldTheirBodies) {
  Bsp<3> tree;
  const auto scene = make(tree, kSmall);
  for (int i = 0; i < 150; ++i) {
    scene->advance();
    for (const Body<3>& body : scene->bodies())
      for (const Vector<3>& point : extremes(body))
        ASSERT_TRUE(contains(widened(body.box), {point, point})) << "step " << scene->step();
  }
}

TEST_P(Scenes, ContactsAreCandidates) {
  Bsp<3> tree;
  const auto scene = make(tree, kSmall);
  advance(*scene, 150);
  const std::vector<Pair> pairs = sorted(scene->pairs());
  EXPECT_TRUE(std::includes(pairs.begin(), pairs.end(), scene->contacts().begin(), scene->contacts().end()));
  EXPECT_LT(scene->contacts().size(), pairs.size());
  EXPECT_GT(scene->contacts().size(), 200U);
}

TEST_P(Scenes, ASilentBroadPhaseGivesNoContact) {
  Silent silent;
  const auto scene = make(silent, kSmall);
  for (int i = 0; i < 100; ++i) {
    scene->advance();
    ASSERT_THAT(scene->contacts(), IsEmpty());
  }
  EXPECT_GT(static_cast<const DropScene&>(*scene).put_back(), 0U)
      << "something other than a pair stopped them";
}

TEST_P(Scenes, KeepsItsWordOnFixedObjects) {
  Seam seam;
  const auto scene = make(seam, kSmall);
  EXPECT_TRUE(scene->needs().fixed_objects);
  EXPECT_GE(seam.fixed.size(), 20U);
  advance(*scene, 100);
  const std::set<ObjectId> moved(seam.moved.begin(), seam.moved.end());
  for (const ObjectId object : seam.fixed) EXPECT_FALSE(moved.contains(object));
  EXPECT_EQ(seam.inserted, scene->bodies().size());
}

/// Those in which objects fall, more and more of them.
std::vector<SceneEntry<3>> drop_scenes() {
  std::vector<SceneEntry<3>> scenes;
  for (const SceneEntry<3>& entry : scenes_3d())
    if (entry.grows) scenes.push_back(entry);
  return scenes;
}

INSTANTIATE_TEST_SUITE_P(All, Scenes, testing::ValuesIn(drop_scenes()), [](const auto& entry) {
  std::string name(entry.param.name);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(Scenes3d, EntriesAreThePapersSimulations) {
  ASSERT_GE(scenes_3d().size(), 4U);
  EXPECT_EQ(scenes_3d()[0].name, "terrain");
  EXPECT_EQ(scenes_3d()[1].name, "attractors");
  EXPECT_EQ(scenes_3d()[2].name, "fracture");
  EXPECT_EQ(scenes_3d()[3].name, "buckets");
}

}  // namespace
}  // namespace kerf
