#include <gtest/gtest.h>

#include "core/tree/partitioner.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/recorded_crowd.h"
#include "tests/viz/debugger/timeline_driver.h"
#include "viz/debugger/model/run_of.h"
#include "viz/debugger/scene/orbit.h"
#include "viz/debugger/scene/pick.h"
#include "viz/debugger/scene/ray.h"
#include "viz/debugger/scene/tints.h"
#include "viz/debugger/scene/visibility.h"
#include "viz/draw/clip.h"
#include "viz/draw/recorded_bodies.h"
#include "viz/draw/view_box.h"

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
  const SightRay ray = ray_through(view, pixel->x(), pixel->y());
  EXPECT_NEAR(ray.start.x(), 1.5, 1e-6);
  EXPECT_NEAR(ray.start.y(), 2.5, 1e-6);
}

TEST(DebuggerOrbit, KeepsWhatIsUnderTheMouseWhenZoomingIn2D) {
  Orbit<2> orbit;
  orbit.set_box({{{-5, 0}}, {{5, 4}}});
  const SightRay before = ray_through(orbit.view(640, 480), 500, 90);
  orbit.zoom(4, 500, 90, 640, 480);
  const SightRay after = ray_through(orbit.view(640, 480), 500, 90);
  EXPECT_NEAR((before.start - after.start).norm(), 0, 1e-6);
  orbit.move(13, -7, 640, 480);
  EXPECT_NEAR((ray_through(orbit.view(640, 480), 513, 83).start - after.start).norm(), 0, 1e-6);
}

/// The lowest objects were below the line that counts them.
TEST(DebuggerOrbit, FramesAllInThePartThatTextLeavesFree) {
  constexpr double kAbove = 24;
  constexpr double kBelow = 42;
  const auto expect_within = [&](const auto& orbit, const auto& box, int height, double most) {
    const View view = orbit.view(640, height);
    for (const Eigen::Vector3d& corner : {to_point(box.min), to_point(box.max)}) {
      const auto pixel = view.project(corner);
      ASSERT_TRUE(pixel.has_value());
      EXPECT_GE(pixel->y(), std::min(kAbove, most));
      EXPECT_LE(pixel->y(), height - std::min(kBelow, most));
    }
  };
  const Box<2> tower{{{-1, 0}}, {{1, 40}}};
  Orbit<2> flat;
  flat.set_box(tower);
  flat.leave_free(kAbove, kBelow);
  expect_within(flat, tower, 480, kBelow);
  expect_within(flat, tower, 60, 0.1);
  const SightRay before = ray_through(flat.view(640, 480), 500, 90);
  flat.zoom(4, 500, 90, 640, 480);
  EXPECT_NEAR((ray_through(flat.view(640, 480), 500, 90).start - before.start).norm(), 0, 1e-6);
  const Box<3> column{{{-1, 0, -1}}, {{1, 40, 1}}};
  Orbit<3> deep;
  deep.set_box(column);
  deep.leave_free(kAbove, kBelow);
  expect_within(deep, column, 480, kBelow);
  const View all = deep.view(640, 480);
  deep.turn(0, 0, 640, 480);
  EXPECT_NEAR(
      (all.project(to_point(column.min)).value() - deep.view(640, 480).project(to_point(column.min)).value())
          .norm(),
      0, 1e-6)
      << "the first move of the mouse changes nothing else";
}

/// No ray meets a point.
template <int D>
void expect_points_are_found() {
  std::vector<Body<D>> bodies(3);
  bodies[0].box = {test::all<D>(-5), test::all<D>(5)};
  bodies[0].mobility = Mobility::fixed;
  bodies[1].box = {test::all<D>(1), test::all<D>(1)};
  bodies[2].box = {test::all<D>(-2), test::all<D>(-2)};
  Orbit<D> orbit;
  orbit.set_box(bodies[0].box);
  const View view = orbit.view(640, 480);
  for (const std::uint32_t id : {1U, 2U}) {
    const Eigen::Vector2d there = *view.project(to_point(bodies[id].box.center()));
    for (const Eigen::Vector2d& aside : {Eigen::Vector2d(0, 0), Eigen::Vector2d(2, -2)})
      EXPECT_EQ(pick_object<D>(bodies, view, there + aside), ObjectId{id});
    EXPECT_EQ(pick_object<D>(bodies, view, there + Eigen::Vector2d(12, 0)), ObjectId{0});
    EXPECT_EQ(pick_object<D>(bodies, view, there + Eigen::Vector2d(8, 0), 2), ObjectId{id})
        << "a fine display";
  }
  bodies[0].mobility = Mobility::moving;
  EXPECT_EQ(pick_object<D>(bodies, view, *view.project(to_point(bodies[1].box.center()))),
            ObjectId{D == 2 ? 1U : 0U})
      << "in 3D it lies within the other one";
}
TEST(DebuggerPick, FindsPointsIn2D) { expect_points_are_found<2>(); }
TEST(DebuggerPick, FindsPointsIn3D) { expect_points_are_found<3>(); }

TEST(DebuggerOrbit, LooksAtAPointFromAsFarAsAtASmallObject) {
  Orbit<2> orbit;
  orbit.set_box({{{-5, 0}}, {{5, 4}}});
  orbit.look_at({{{1, 1}}, {{1, 1}}}, 640, 480);
  EXPECT_GT(*orbit.choice().width, 0.5);
  EXPECT_LT(*orbit.choice().width, 2);
}

TEST(DebuggerOrbit, LooksAtABox) {
  Orbit<3> orbit;
  orbit.set_box(kRoom);
  orbit.look_at({{{2, 1, 2}}, {{3, 2, 3}}}, 640, 480);
  const auto pixel = orbit.view(640, 480).project({2.5, 1.5, 2.5});
  ASSERT_TRUE(pixel.has_value());
  EXPECT_NEAR(pixel->x(), 320, 0.5);
  EXPECT_NEAR(pixel->y(), 240, 0.5);
}

TEST(DebuggerOrbit, FacesADirectionAtWhatItLooksAt) {
  Orbit<3> orbit;
  orbit.set_box(kRoom);
  orbit.look_at({{{2, 1, 2}}, {{3, 2, 3}}}, 640, 480);
  orbit.turn(100, 30, 640, 480);
  orbit.face("top");
  const View top = orbit.view(640, 480);
  EXPECT_NEAR(top.forward.y(), -1, 1e-9);
  EXPECT_NEAR(top.project({2.5, 1.5, 2.5})->x(), 320, 0.5);
  orbit.face("front");
  EXPECT_NEAR(orbit.view(640, 480).forward.z(), -1, 1e-9);
}

TEST(DebuggerViewSettings, DirectionsFollowEachOther) {
  ViewSettings settings;
  std::vector<std::string_view> seen;
  for (int k = 0; k < 5; ++k) {
    settings.face_next(true);
    seen.push_back(settings.facing.direction);
  }
  EXPECT_EQ(seen, (std::vector<std::string_view>{"iso", "top", "front", "side", "iso"}));
  settings.face_next(false);
  EXPECT_EQ(settings.facing.direction, "side");
  const ViewSettings before = settings;
  settings.face("side");
  EXPECT_NE(settings, before) << "a second wish for the same turns the view again";
}

TEST(DebuggerRay, EntersWhatHalfSpacesLeave) {
  const SightRay ray{{-5, 0.5, 0.5}, {2, 0, 0}};
  const Box<3> box{{{1, 0, 0}}, {{2, 1, 1}}};
  const auto sides = half_spaces(box);
  EXPECT_EQ(distance_to(ray, sides), 3);
  EXPECT_EQ(distance_to({{1.5, 0.5, 0.5}, ray.way}, sides), 0);
  EXPECT_EQ(distance_to({{3, 0.5, 0.5}, ray.way}, sides), std::nullopt);
  EXPECT_EQ(distance_to({{-5, 2, 0.5}, ray.way}, sides), std::nullopt);
}

template <class T>
class DebuggerPick : public testing::Test {
 protected:
  static constexpr int kD = T::value;

  DebuggerPick() {
    test::record_crowd<kD>(file_.path(), 60, test::busy_config());
    run_ = std::make_unique<RunOf<kD>>(file_.path());
    run_->go(Position::end_of(60));
    bodies_ = recorded_bodies(run_->state().latest);
    ViewBox<kD> box;
    box.update(bodies_);
    bounds_ = box.box();
    orbit_.set_box(bounds_);
    view_ = orbit_.view(kWidth, kHeight);
    snapshot_.assign(&run_->state().tree);
    for_each_node(run_->state().tree, run_->state().tree.root(), [&](NodeId id) {
      seen_.resize(std::max(seen_.size(), id.index() + 1));
      seen_[id.index()] = 1;
      if (!snapshot_[id].is_leaf()) inner_.push_back(id);
    });
  }
  [[nodiscard]] std::optional<NodeId> pick(const Eigen::Vector3d& point) const {
    const auto pixel = view_.project(point);
    return pick_node<kD>({snapshot_, inner_, seen_, bounds_}, view_, pixel->x(), pixel->y());
  }
  /// Whether the node's cell, or what of the partitioner lies in it, is seen at that point of the picture.
  [[nodiscard]] bool reaches(NodeId id, const Eigen::Vector3d& point) const {
    const auto pixel = view_.project(point);
    std::vector<HalfSpace> sides = half_spaces(bounds_);
    for (const HalfSpace& side : cell_sides(snapshot_, id)) sides.push_back(side);
    return distance_to(ray_through(view_, pixel->x(), pixel->y()), sides).has_value();
  }

  static constexpr int kWidth = 800;
  static constexpr int kHeight = 600;
  test::TemporaryRecording file_;
  std::unique_ptr<RunOf<kD>> run_;
  std::vector<Body<kD>> bodies_;
  Box<kD> bounds_;
  Orbit<kD> orbit_;
  View view_;
  TreeSnapshotOf<kD> snapshot_;
  std::vector<std::uint8_t> seen_;
  std::vector<NodeId> inner_;
};
TYPED_TEST_SUITE(DebuggerPick, test::Dimensions, test::DimensionNames);

TYPED_TEST(DebuggerPick, APartitionerByItsLine) {
  std::size_t seen = 0;
  std::size_t exact = 0;
  for (const NodeId id : this->inner_) {
    const Polygon line = partitioner_in_cell(this->snapshot_, id, this->bounds_);
    if (line.size() < 2) continue;  // beyond all objects
    ++seen;
    const auto found = this->pick(0.5 * (line[0] + line[1]));
    ASSERT_TRUE(found.has_value());
    EXPECT_FALSE(this->snapshot_[*found].is_leaf()) << "n" << id.value;
    exact += *found == id ? 1 : 0;  // others may have a line in the same place
  }
  EXPECT_GT(seen, 5U);
  EXPECT_GT(4 * exact, 3 * seen);
}

TYPED_TEST(DebuggerPick, ALeafWhereThereIsNoLine) {
  std::size_t leaves = 0;
  for (double x = 0.05; x < 1; x += 0.1)
    for (double y = 0.05; y < 1; y += 0.1) {
      Eigen::Vector3d point = to_point(this->bounds_.center());
      point.x() = double{this->bounds_.min[0]} + x * double{this->bounds_.extent()[0]};
      point.y() = double{this->bounds_.min[1]} + y * double{this->bounds_.extent()[1]};
      const auto found = this->pick(point);
      ASSERT_TRUE(found.has_value());
      EXPECT_TRUE(this->reaches(*found, point));
      leaves += this->snapshot_[*found].is_leaf() ? 1 : 0;
    }
  EXPECT_GT(leaves, 5U);
  const auto beside = pick_node<TypeParam::value>({this->snapshot_, this->inner_, this->seen_, this->bounds_},
                                                  this->view_, 1, 1);
  EXPECT_EQ(beside, std::nullopt);
}

/// Its node is gone once it has acted, and so was the mark of it.
TEST(DebuggerMarks, ASwapIsSeenWhereItsNodeWas) {
  test::TimelineDriver driver;
  EXPECT_EQ(driver.play("click condition\ntype \"op==swap && kind==acted\"\nkey Enter\nkey F5\nwait 2\n"
                        "expect message ~ \"stopped at\""),
            "");
  kerf::Run& run = driver.debugger().model().run();
  ASSERT_TRUE(run.event() && run.event_node());
  ASSERT_FALSE(run.tree().is_alive(*run.event_node()));
  const std::string label =
      "e" + std::to_string(run.event()->id) + "  n" + std::to_string(run.event_node()->value);
  EXPECT_EQ(driver.play("expect labels ~ \"" + label + "\""), "");
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

TEST(DebuggerVisibility, ANodeThatIsNotAliveIsNotAlone) {
  test::TimelineDriver driver;
  EXPECT_EQ(driver.play("key End\nwait 1\nremember all drawn_objects\nclick n1\nkey i\nwait 1\n"
                        "expect alone == n1\nexpect drawn_objects < $all"),
            "");
  driver.debugger().model().view.isolated = NodeId{4'000'000'000};
  EXPECT_EQ(driver.play("key End\nwait 1\nremember all all_objects\n"
                        "expect alone == \"n4000000000, not alive here\"\nexpect drawn_objects == $all\n"
                        "key i\nwait 1\nexpect alone == none"),
            "");
}

TEST(DebuggerVisibility, TintsGoFromNothingToOne) {
  const test::TemporaryRecording file;
  test::record_crowd<2>(file.path(), 60, test::busy_config());
  RunOf<2> run(file.path());
  run.go(Position::end_of(60));
  for (const Tint tint : {Tint::population, Tint::balance, Tint::redundancy, Tint::cost, Tint::age}) {
    const auto changes = last_changes(run.operators(), run.position(), run.tree().nodes().size());
    const NodeTints tints = find_tints({run.tree(), 60, changes}, tint);
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

TEST(DebuggerVisibility, APartitionerHasTheTintOfTheFullestLeafBelowIt) {
  const test::TemporaryRecording file;
  test::record_crowd<2>(file.path(), 60, test::busy_config());
  RunOf<2> run(file.path());
  run.go(Position::end_of(60));
  const TreeSnapshot& tree = run.tree();
  const NodeTints full = find_tints({tree, 60, {}}, Tint::population);
  const NodeTints balanced = find_tints({tree, 60, {}}, Tint::balance);
  EXPECT_EQ(full.values[tree.root().index()], static_cast<float>(tree.largest_leaf()));
  EXPECT_EQ(balanced.values[tree.root().index()], balance(tree.quality(tree.root())));
}

}  // namespace
}  // namespace kerf
