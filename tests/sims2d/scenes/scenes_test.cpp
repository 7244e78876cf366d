#include "sims2d/scenes/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>

#include "core/broad_phase/brute_force.h"
#include "core/bsp/bsp.h"
#include "sims2d/convert.h"
#include "sims2d/scenes/growth.h"
#include "tests/sims2d/broad_phase_doubles.h"
#include "tests/sims2d/scenes/scene_fixture.h"

namespace kerf::test {
namespace {

class SceneList : public Scenes2d {};

std::uint32_t moving_bodies(const Scene<2>& scene) {
  const auto bodies = scene.bodies();
  return static_cast<std::uint32_t>(
      std::ranges::count(bodies, Mobility::moving, [](const Body<2>& body) { return body.mobility; }));
}

/// The inside of the yard: its ground and walls are the first three bodies.
Box<2> yard_of(const Scene<2>& scene) {
  const auto bodies = scene.bodies();
  return {{{bodies[1].box.max[0], bodies[0].box.max[1]}},
          {{bodies[2].box.min[0], std::numeric_limits<float>::max()}}};
}

bool inside(const Brick<2>& brick, const Vector<2>& point) {
  return std::abs(point[0]) < brick.half[0] && std::abs(point[1]) < brick.half[1];
}

bool inside(const Outline& outline, const Vector<2>& point) {
  for (std::size_t k = 0; k < outline.corners.size(); ++k) {
    const Vector<2> side = outline.corners[(k + 1) % outline.corners.size()] - outline.corners[k];
    const Vector<2> d = point - outline.corners[k];
    if (side[0] * d[1] <= side[1] * d[0]) return false;
  }
  return true;
}

bool inside(const Ball& ball, const Vector<2>& point) { return length(point) < ball.radius; }

bool inside_fixed(const Body<2>& body, const Vector<2>& point) {
  if (body.mobility != Mobility::fixed) return false;
  const Vector<2> d = point - body.pose.position;
  const Vector<2> own{{dot(d, body.pose.axes[0]), dot(d, body.pose.axes[1])}};
  return std::visit([&own](const auto& shape) { return inside(shape, own); }, body.shape);
}

TEST(SceneNames, AreThoseThatUsersKnow) {
  std::set<std::string_view> names;
  for (const SceneEntry<2>& entry : scenes_2d()) names.insert(entry.name);
  EXPECT_THAT(names, ::testing::ElementsAre("attractors", "buckets", "fracture", "pile", "pyramid", "rods",
                                            "terrain", "tumbler"));
}

TEST_P(SceneList, GrowsEvenlyToItsNumber) {
  Bsp<2> tree;
  const auto scene = make(tree, {.objects = 120, .steps = 90, .seed = 1});
  const Growth growth{120, 90};
  EXPECT_EQ(moving_bodies(*scene), 0U);
  for (std::uint32_t step = 1; step <= 120; ++step) {
    scene->advance();
    ASSERT_EQ(scene->step(), step);
    ASSERT_EQ(moving_bodies(*scene), growth.due(step)) << "step " << step;
  }
  EXPECT_EQ(moving_bodies(*scene), 120U);
}

TEST_P(SceneList, ZerosMeanTheScenesOwnNumbers) {
  Bsp<2> tree;
  const auto scene = make(tree, {});
  const Growth growth = growth_of({}, GetParam().default_objects);
  EXPECT_EQ(growth.objects, GetParam().default_objects);
  EXPECT_GE(growth.steps, 200U) << "too short for a film";
  for (std::uint32_t step = 1; step < growth.steps; ++step) scene->advance();
  EXPECT_LT(moving_bodies(*scene), growth.objects);
  scene->advance();
  EXPECT_EQ(moving_bodies(*scene), growth.objects);
}

TEST_P(SceneList, NeverPlacesAnObjectOnAnother) {
  for (const std::uint32_t steps : {1U, 10U, 400U}) {
    Bsp<2> tree;
    const auto scene = make(tree, {.objects = 300, .steps = steps, .seed = 2});
    std::size_t before = scene->bodies().size();
    for (std::uint32_t step = 1; step <= steps; ++step) {
      scene->advance();
      for (const Pair& pair : scene->pairs())
        ASSERT_LT(pair.b.index(), before) << "object " << pair.b.value << " came upon " << pair.a.value;
      before = scene->bodies().size();
    }
  }
}

TEST_P(SceneList, KeepsEveryBodyInTheYardAndOutOfTheWalls) {
  Bsp<2> tree;
  const auto scene = make(tree, {.objects = 400, .steps = 100, .seed = 6});
  const Box<2> yard = yard_of(*scene);
  for (int step = 1; step <= 600; ++step) {
    scene->advance();
    for (const Body<2>& body : scene->bodies()) {
      const Vector<2> p = body.pose.position;
      if (body.mobility == Mobility::fixed) continue;
      ASSERT_TRUE(contains(yard, Box<2>{p, p})) << "step " << step << ": " << p[0] << ", " << p[1];
      for (const Body<2>& other : scene->bodies()) ASSERT_FALSE(inside_fixed(other, p)) << "step " << step;
    }
  }
}

TEST_P(SceneList, MovesNothingFastEnoughToPassThroughAnother) {
  Bsp<2> tree;
  const auto scene = make(tree, {.objects = 400, .steps = 100, .seed = 8});
  for (int step = 1; step <= 400; ++step) {
    const std::vector<Body<2>> before(scene->bodies().begin(), scene->bodies().end());
    scene->advance();
    for (std::size_t i = 0; i < before.size(); ++i)
      ASSERT_LT(length(scene->bodies()[i].pose.position - before[i].pose.position), 0.5F) << "step " << step;
  }
}

TEST_P(SceneList, RefusesAnAbsurdNumberOfObjects) {
  SilentBroadPhase broad_phase;
  try {
    make(broad_phase, {.objects = kMaxObjects2d + 1});
    FAIL() << "no error";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(),
                ::testing::HasSubstr("100001 objects are too many: at most 100000 are possible"));
  }
}

TEST_P(SceneList, TakesOneObjectAndTheLargestNumber) {
  for (const std::uint32_t objects : {1U, 2U, kMaxObjects2d}) {
    SilentBroadPhase broad_phase;
    const auto scene = make(broad_phase, {.objects = objects, .steps = 1});
    scene->advance();
    EXPECT_EQ(moving_bodies(*scene), objects);
  }
}

INSTANTIATE_TEST_SUITE_P(All, SceneList, ::testing::ValuesIn(rain_scenes()), scene_name);

}  // namespace
}  // namespace kerf::test
