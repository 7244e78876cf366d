#include "frames/story/slide_plane.h"

#include <gtest/gtest.h>

#include "frames/story/blend.h"
#include "tests/support/dimensions.h"
#include "tests/viz/small_scene.h"

namespace kerf {
namespace {

/// A plan in which the newest operator of its kind is highlighted.
template <int D>
struct PlannedMoment {
  explicit PlannedMoment(Operator op) {
    const test::SmallScene<D> scene;
    FramePlanner<D> planner(LayerSet::all(), 1);
    plan = planner.plan(scene.input());
    for (const Highlight& highlight : plan.highlights)
      if (highlight.acted.op == op && plan.snapshot.is_alive(highlight.acted.node))
        moment = {scene.caption().step, highlight.event, highlight.acted};
  }
  [[nodiscard]] const Highlight& highlight() const {
    return *std::ranges::find(plan.highlights, moment.event, &Highlight::event);
  }

  FramePlan<D> plan;
  StoryMoment moment;
};

double width_of(const Polygon& polygon) {
  double most = 0;
  for (const Eigen::Vector3d& a : polygon)
    for (const Eigen::Vector3d& b : polygon) most = std::max(most, (a - b).norm());
  return most;
}

template <class T>
class SlidePlane : public testing::Test {};
TYPED_TEST_SUITE(SlidePlane, test::Dimensions, test::DimensionNames);

TYPED_TEST(SlidePlane, OfASplitGrowsToItsPlace) {
  constexpr int kD = TypeParam::value;
  const PlannedMoment<kD> before(Operator::split);
  ASSERT_TRUE(before.moment.acted.node.node.value < before.plan.snapshot.nodes().size());
  const double whole = width_of(before.highlight().partitioner);
  ASSERT_GT(whole, 0);
  double last = -1;
  for (const double progress : {0.0, 0.4, 0.5, 1.0}) {
    PlannedMoment<kD> at = before;
    slide_plane(at.plan, at.moment, progress);
    const double now = width_of(at.highlight().partitioner);
    EXPECT_GT(now, last);
    last = now;
  }
  EXPECT_NEAR(last, whole, 1e-9);
}

/// A plane whose node has another one meanwhile stays where it is.
TYPED_TEST(SlidePlane, OfABalanceGoesFromItsOldToItsNewPlace) {
  constexpr int kD = TypeParam::value;
  PlannedMoment<kD> planned(Operator::split);
  const NodeRef node = planned.moment.acted.node;
  ASSERT_FALSE(planned.plan.snapshot[node.node].is_leaf());
  const Scalar now = planned.plan.snapshot.plane(node.node).offset;
  for (Highlight& highlight : planned.plan.highlights) {
    if (highlight.event != planned.moment.event) continue;
    highlight.acted.op = Operator::balance;
    highlight.acted.old_offset = now - 1;
    highlight.acted.new_offset = now;
    planned.moment.acted = highlight.acted;
  }
  const auto offset_at = [&](double progress) {
    PlannedMoment<kD> at = planned;
    slide_plane(at.plan, at.moment, progress);
    return at.plan.snapshot.plane(node.node).offset;
  };
  EXPECT_FLOAT_EQ(offset_at(0), now - 1);
  EXPECT_NEAR(offset_at(0.45), now - 0.5F, 1e-4F);
  EXPECT_FLOAT_EQ(offset_at(1), now);
}

TYPED_TEST(SlidePlane, BodiesMoveBetweenSteps) {
  constexpr int kD = TypeParam::value;
  Body<kD> body;
  body.shape = Brick<kD>{};
  std::vector<Body<kD>> from{body};
  body.pose.position[0] = 4;
  body.box.max[0] = 4;
  const std::vector<Body<kD>> to{body, body};
  const auto half = blend(from, to, 0.25);
  ASSERT_EQ(half.size(), 1U) << "what comes in the later step is not there yet";
  EXPECT_FLOAT_EQ(half[0].pose.position[0], 1);
  EXPECT_FLOAT_EQ(half[0].box.max[0] - from[0].box.max[0], (to[0].box.max[0] - from[0].box.max[0]) / 4);
}

}  // namespace
}  // namespace kerf
