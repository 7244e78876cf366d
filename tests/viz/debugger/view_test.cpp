#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/recorded_crowd.h"
#include "viz/debugger/model/run_of.h"
#include "viz/debugger/scene/orbit.h"
#include "viz/debugger/scene/ray.h"
#include "viz/debugger/scene/visibility.h"
#include "viz/draw/clip.h"

namespace kerf {
namespace {

const Box<3> kRoom{{{-5, 0, -5}}, {{5, 4, 5}}};

TEST(DebuggerRay, MeetsWhatIsSeenAtAPixel) {
  Orbit<3> orbit;
  orbit.set_box(kRoom);
  orbit.turn(40, -20, 640, 480);
  const View view = orbit.view(640, 480);
  const Box<3> box{{{1, 1, 1}}, {{2, 2, 2}}};
  const auto pixel = view.project(to_point(box.center()));
  ASSERT_TRUE(pixel.has_value());
  EXPECT_TRUE(distance_to(ray_through(view, pixel->x(), pixel->y()), box).has_value());
  EXPECT_FALSE(distance_to(ray_through(view, pixel->x() + 200, pixel->y()), box).has_value());
}

TEST(DebuggerRay, FindsThePlaneOf2D) {
  Orbit<2> orbit;
  orbit.set_box({{{-5, 0}}, {{5, 4}}});
  orbit.zoom(3, 100, 50, 640, 480);
  const View view = orbit.view(640, 480);
  const auto pixel = view.project({1.5, 2.5, 0});
  ASSERT_TRUE(pixel.has_value());
  const Ray ray = ray_through(view, pixel->x(), pixel->y());
  EXPECT_NEAR(ray.start.x(), 1.5, 1e-6);
  EXPECT_NEAR(ray.start.y(), 2.5, 1e-6);
}

TEST(DebuggerOrbit, KeepsWhatIsUnderTheMouseWhenZoomingIn2D) {
  Orbit<2> orbit;
  orbit.set_box({{{-5, 0}}, {{5, 4}}});
  const Ray before = ray_through(orbit.view(640, 480), 500, 90);
  orbit.zoom(4, 500, 90, 640, 480);
  const Ray after = ray_through(orbit.view(640, 480), 500, 90);
  EXPECT_NEAR((before.start - after.start).norm(), 0, 1e-6);
  orbit.move(13, -7, 640, 480);
  EXPECT_NEAR((ray_through(orbit.view(640, 480), 513, 83).start - after.start).norm(), 0, 1e-6);
}

TEST(DebuggerOrbit, LooksAtWhatItIsTold) {
  Orbit<3> orbit;
  orbit.set_box(kRoom);
  orbit.look_at({{{2, 1, 2}}, {{3, 2, 3}}}, 640, 480);
  const auto pixel = orbit.view(640, 480).project({2.5, 1.5, 2.5});
  ASSERT_TRUE(pixel.has_value());
  EXPECT_NEAR(pixel->x(), 320, 0.5);
  EXPECT_NEAR(pixel->y(), 240, 0.5);
}

TEST(DebuggerVisibility, IsolatedAndHiddenNodesDecideWhatIsSeen) {
  const test::TemporaryRecording file;
  test::record_crowd<2>(file.path(), 60, test::busy_config());
  RunOf<2> run(file.path());
  run.go(Position::end_of(60));
  const Tree<2>& tree = run.state().tree;
  const NodeId left = tree[tree.root()].left;
  const std::size_t objects = run.state().latest.bound();
  ViewSettings settings;
  settings.isolated = left;
  const Visibility alone = find_visible(tree, objects, settings);
  EXPECT_EQ(alone.nodes[tree.root().index()], 0);
  EXPECT_EQ(alone.nodes[left.index()], 1);
  EXPECT_EQ(std::count(alone.objects.begin(), alone.objects.end(), 1), tree[left].population);
  settings.isolated.reset();
  settings.hidden_nodes = {left};
  const Visibility rest = find_visible(tree, objects, settings);
  EXPECT_EQ(std::count(rest.objects.begin(), rest.objects.end(), 1),
            tree[tree[tree.root()].right].population);
}

TEST(DebuggerVisibility, TintsGoFromNothingToOne) {
  const test::TemporaryRecording file;
  test::record_crowd<2>(file.path(), 60, test::busy_config());
  RunOf<2> run(file.path());
  run.go(Position::end_of(60));
  for (const Tint tint : {Tint::population, Tint::balance, Tint::redundancy, Tint::cost, Tint::age}) {
    const NodeTints tints = find_tints(run, tint);
    float most = 0;
    for (std::uint32_t id = 0; id < tints.values.size(); ++id) {
      const float share = tints.share(NodeId{id}, tints.end);
      EXPECT_GE(share, 0);
      EXPECT_LE(share, 1);
      EXPECT_NEAR(tints.share(NodeId{id}, 2 * tints.end), 0.5F * std::min(1.0F, share),
                  share == 1 ? 0.5 : 1e-6);
      most = std::max(most, share);
    }
    EXPECT_GT(most, 0) << static_cast<int>(tint);
  }
}

}  // namespace
}  // namespace kerf
