#include "viz/draw/highlights.h"

#include <gtest/gtest.h>

#include "tests/support/dimensions.h"
#include "tests/viz/small_scene.h"
#include "viz/draw/overlay.h"

namespace kerf {
namespace {

template <int D>
class Fixture {
 public:
  Fixture() { snapshot.assign(&scene.tree()); }

  [[nodiscard]] Event event(std::uint64_t id, std::uint32_t step, Operator op, NodeRef node) const {
    return {id, step, OperatorActed{op, node, {}, {}, 0, 3, 5}};
  }
  [[nodiscard]] FrameInput<D> input(const std::vector<Event>& events, std::uint32_t step) const {
    FrameInput<D> result = scene.input();
    result.events = events;
    result.caption.step = step;
    return result;
  }

  test::SmallScene<D> scene;
  TreeSnapshotOf<D> snapshot;
  TreeSnapshotOf<D> nothing;
  Box<D> bounds{test::all<D>(-1), test::all<D>(13)};
  Highlights<D> highlights;
};

template <class T>
class HighlightsTest : public testing::Test {};
TYPED_TEST_SUITE(HighlightsTest, test::Dimensions, test::DimensionNames);

TYPED_TEST(HighlightsTest, LivingNodeShowsItsCellAndPlanes) {
  constexpr int kD = TypeParam::value;
  Fixture<kD> f;
  const NodeRef root = f.scene.tree().ref(f.scene.tree().root());
  const std::vector<Event> events{f.event(1, 20, Operator::balance, root)};
  f.highlights.update(f.input(events, 20), {f.snapshot}, {f.nothing}, f.bounds);
  ASSERT_EQ(f.highlights.all().size(), 1U);
  const Highlight& shown = f.highlights.all()[0];
  EXPECT_FALSE(shown.faces.empty());
  EXPECT_FALSE(shown.partitioner.empty());
  EXPECT_FALSE(shown.old_partitioner.empty());
  EXPECT_EQ(shown.label(), "balance n" + std::to_string(root.node.value));
  EXPECT_EQ(shown.strength(), 1);
}

TEST(HighlightSentences, SayWhyAnOperatorActedAndWhatBecame) {
  const auto sentence = [](Operator op, const Quality& before, const Quality& after) {
    Highlight highlight;
    highlight.acted = {op, {{26}, 0}, before, after, 0, 0, 0};
    return highlight.sentence();
  };
  EXPECT_EQ(sentence(Operator::split, {119, 0, 0}, {119, 61, 58}),
            "leaf n26 got crowded: split into 61 and 58");
  EXPECT_EQ(sentence(Operator::shift_split, {119, 0, 0}, {119, 61, 58}),
            "leaf n26 got crowded: split parallel to its parent's plane into 61 and 58");
  EXPECT_EQ(sentence(Operator::balance, {90, 70, 21}, {90, 46, 45}),
            "node n26 divided badly (70 | 21): its plane moved, now 46 | 45");
  EXPECT_EQ(sentence(Operator::swap, {120, 118, 3}, {120, 60, 60}),
            "node n26 divided badly (118 | 3): its plane was removed");
  EXPECT_EQ(sentence(Operator::merge, {12, 7, 5}, {12, 0, 0}), "node n26 was dissolved into a leaf of 12");
}

/// Objects have moved since: its figures are of then, and the step is named.
TEST(HighlightSentences, OfAnEarlierStepSayWhen) {
  Highlight highlight;
  highlight.acted = {Operator::balance, {{26}, 0}, {90, 70, 21}, {90, 46, 45}, 0, 0, 0};
  const Font font(16);
  highlight.age = 3;
  EXPECT_EQ(log_line(font, 1280, "", {highlight}),
            "3 steps ago node n26 divided badly (70 | 21): its plane moved, then 46 | 45");
  highlight.age = 0;
  EXPECT_EQ(log_line(font, 1280, "", {highlight}),
            "node n26 divided badly (70 | 21): its plane moved, now 46 | 45");
}

TYPED_TEST(HighlightsTest, DeadNodeKeepsItsLastCellWhileItFades) {
  constexpr int kD = TypeParam::value;
  Fixture<kD> f;
  const NodeRef root = f.scene.tree().ref(f.scene.tree().root());
  const std::vector<Event> events{f.event(1, 20, Operator::swap, root)};
  // The node lived in the frame before and is gone now, and in the frame after.
  f.highlights.update(f.input(events, 20), {f.nothing}, {f.snapshot}, f.bounds);
  EXPECT_FALSE(f.highlights.all().at(0).faces.empty());
  f.highlights.update(f.input(events, 24), {f.nothing}, {f.nothing}, f.bounds);
  EXPECT_FALSE(f.highlights.all().at(0).faces.empty());
  EXPECT_EQ(f.highlights.all().at(0).age, 4U);
  EXPECT_LT(f.highlights.all().at(0).strength(), 1);
}

TYPED_TEST(HighlightsTest, OldEventsGoAndTheNewestOfANodeCounts) {
  constexpr int kD = TypeParam::value;
  Fixture<kD> f;
  const NodeRef root = f.scene.tree().ref(f.scene.tree().root());
  const std::vector<Event> events{f.event(1, 20, Operator::split, root),
                                  f.event(2, 22, Operator::balance, root)};
  f.highlights.update(f.input(events, 22), {f.snapshot}, {f.nothing}, f.bounds);
  ASSERT_EQ(f.highlights.all().size(), 1U);
  EXPECT_EQ(f.highlights.all()[0].acted.op, Operator::balance);
  f.highlights.update(f.input(events, 22 + kHighlightSteps + 1), {f.snapshot}, {f.nothing}, f.bounds);
  EXPECT_TRUE(f.highlights.all().empty());
}

TYPED_TEST(HighlightsTest, AFilmMayKeepThemLongerAndTheirAnchorsStandStill) {
  constexpr int kD = TypeParam::value;
  Fixture<kD> f;
  const NodeRef root = f.scene.tree().ref(f.scene.tree().root());
  const std::vector<Event> events{f.event(1, 20, Operator::balance, root)};
  FrameInput<kD> input = f.input(events, 20);
  input.highlight_steps = 40;
  f.highlights.update(input, {f.snapshot}, {f.nothing}, f.bounds);
  const auto anchor = f.highlights.all().at(0).anchor;
  ASSERT_TRUE(anchor.has_value());
  input.caption.step = 40;
  Box<kD> wider = f.bounds;
  wider.max[0] += 10;
  f.highlights.update(input, {f.snapshot}, {f.nothing}, wider);
  EXPECT_EQ(f.highlights.all().at(0).anchor, anchor);
  EXPECT_NEAR(f.highlights.all().at(0).strength(), 0.625, 1e-9);
  input.caption.step = 61;
  f.highlights.update(input, {f.snapshot}, {f.nothing}, f.bounds);
  EXPECT_TRUE(f.highlights.all().empty());
}

TYPED_TEST(HighlightsTest, NodeNeverSeenHasALabelOnly) {
  constexpr int kD = TypeParam::value;
  Fixture<kD> f;
  const std::vector<Event> events{f.event(1, 20, Operator::merge, {NodeId{4000}, 3})};
  f.highlights.update(f.input(events, 20), {f.snapshot}, {f.nothing}, f.bounds);
  ASSERT_EQ(f.highlights.all().size(), 1U);
  EXPECT_TRUE(f.highlights.all()[0].faces.empty());
}

}  // namespace
}  // namespace kerf
