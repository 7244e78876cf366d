#include <gmock/gmock.h>

#include <algorithm>
#include <iterator>

#include "tests/support/default_window.h"
#include "tests/viz/debugger/timeline_driver.h"
#include "viz/debugger/model/icicle_state.h"
#include "viz/debugger/model/recent_operators.h"
#include "viz/debugger/model/tree_walk.h"

namespace kerf::test {
namespace {

using ::testing::ElementsAreArray;

/// A run of a crowd, at a split.
class DebuggerIcicle : public testing::Test {
 protected:
  DebuggerIcicle() { go_to("op==split && kind==acted && step>20"); }

  void go_to(const std::string& condition) {
    model().go(model().run().search(Expression::parse(condition), {}, true, {}).value_or(Position{}));
  }
  [[nodiscard]] DebuggerModel& model() { return driver_.debugger().model(); }
  [[nodiscard]] kerf::Run& run() { return model().run(); }
  [[nodiscard]] TimelineDriver& driver() { return driver_; }

 private:
  TimelineDriver driver_;
};

std::vector<NodeId> nodes_in(const IcicleState& icicle) {
  std::vector<NodeId> nodes;
  for (const IcicleBar& bar : icicle.bars) nodes.push_back(bar.node);
  return nodes;
}

TEST_F(DebuggerIcicle, BeforeIsTheTreeBeforeTheLastOperator) {
  const std::uint64_t event = run().event()->id;
  const IcicleState now = make_icicle(run(), {}, false);
  const IcicleState before = make_icicle(run(), {}, true);
  EXPECT_EQ(now.bars.size(), before.bars.size() + 2);  // a split makes two leaves
  EXPECT_TRUE(tree_of(before, run()).nodes()[before.acted->index()].is_leaf());
  EXPECT_FALSE(tree_of(now, run()).nodes()[now.acted->index()].is_leaf());
  EXPECT_EQ(before.last->event, event);
  EXPECT_EQ(before.acted, now.acted);
  model().step(Granularity::event, false);
  const std::vector<NodeId> really = nodes_in(make_icicle(run(), {}, false));
  EXPECT_THAT(nodes_in(before), ElementsAreArray(really));
  model().go(Position::end_of(model().run().step_of(event).value()));
  EXPECT_GE(make_icicle(run(), {}, true).last->event, event);  // an operator at the end of the step, too
  model().go({});
  EXPECT_EQ(make_icicle(run(), {}, true).last, std::nullopt);
}

TEST_F(DebuggerIcicle, NodesOfOperatorsFadeOverSteps) {
  const NodeId node = *run().event_node();
  const std::uint32_t step = run().position().step;
  EXPECT_EQ(recent_operators(run())[node], 1);
  double last = 1;
  for (std::uint32_t later = 1; later < kMarkedSteps; ++later) {
    model().go(Position::end_of(step + later));
    const auto marked = recent_operators(run());
    if (!marked.contains(node) || marked.at(node) > last) return;  // it died, or something acted on it again
    EXPECT_EQ(marked.at(node), 1 - later / double{kMarkedSteps});
    last = marked.at(node);
  }
  model().go({});
  EXPECT_TRUE(recent_operators(run()).empty());
}

TEST_F(DebuggerIcicle, MarksOfTheSelection) {
  model().go(Position::end_of(60));
  std::size_t fewer = 0;
  for (const Pair& pair : run().pairs()) {
    const std::vector<NodeId> a = run().leaves_of(pair.a);
    const std::vector<NodeId> b = run().leaves_of(pair.b);
    const std::set<NodeId> leaves(a.begin(), a.end());
    EXPECT_EQ(make_icicle(run(), pair.a, false).selected, leaves);
    std::set<NodeId> both;
    std::ranges::copy_if(b, std::inserter(both, both.end()),
                         [&](NodeId leaf) { return leaves.contains(leaf); });
    EXPECT_EQ(make_icicle(run(), pair, false).selected, both);
    fewer += both.size() < leaves.size() ? 1 : 0;
  }
  EXPECT_GT(fewer, 0U);
  EXPECT_EQ(make_icicle(run(), NodeId{0}, false).selected, std::set<NodeId>{NodeId{0}});
}

TEST_F(DebuggerIcicle, WalksFromNodeToNode) {
  const TreeSnapshot& tree = run().tree();
  const NodeId root = tree.root();
  const NodeId left = tree[root].left;
  EXPECT_EQ(neighbour_of(tree, std::nullopt, TreeWay::up), root);
  EXPECT_EQ(neighbour_of(tree, root, TreeWay::up), root);
  EXPECT_EQ(neighbour_of(tree, root, TreeWay::left), left);
  EXPECT_EQ(neighbour_of(tree, left, TreeWay::across), tree[root].right);
  EXPECT_EQ(neighbour_of(tree, tree[root].right, TreeWay::across), left);
  EXPECT_EQ(neighbour_of(tree, left, TreeWay::up), root);
}

TEST_F(DebuggerIcicle, MouseAndKeysInThePanel) {
  const TreeSnapshot& tree = run().tree();
  const std::string left = "n" + std::to_string(tree[tree.root()].left.value);
  const std::string right = "n" + std::to_string(tree[tree.root()].right.value);
  EXPECT_EQ(driver().play("expect hovered_node == none\nhover icicle@0.5,0.02\nexpect hovered_node == n0\n"
                          "click \"bar " +
                          left + "\"\nexpect selection == " + left +
                          "\nhover n0\nexpect hovered_node == n0\nhover 5,400\nexpect hovered_node == none\n"
                          "key X\nexpect selection == " +
                          right +
                          "\nkey U\nexpect selection == n0\n"
                          "key D\nexpect selection == " +
                          left + "\nkey U\nkey shift+D\nexpect selection == " + right +
                          "\nremember state state\nkey A\nexpect icicle == before\n"
                          "expect state == $state\nclick before\nexpect icicle == now"),
            "");
}

TEST_F(DebuggerIcicle, TheSceneMarksTheNodeUnderTheMouse) {
  EXPECT_EQ(driver().play("hover 5,400\nwait 3\nremember before pictures\nhover icicle@0.5,0.02\nwait 2\n"
                          "expect pictures > $before\nremember after pictures\nwait 3\n"
                          "expect pictures == $after"),
            "");
}

Image view_of(TimelineDriver& driver) {
  const PanelArea area = test::DefaultWindow(1280, 720).all().view;
  const Image& all = driver.debugger().picture();
  Image part = make_image(static_cast<int>(area.width), static_cast<int>(area.height));
  for (int y = 0; y < part.height; ++y)
    std::copy_n(all.pixel(static_cast<int>(area.x), static_cast<int>(area.y) + y), part.stride(),
                part.rgba.begin() + static_cast<std::ptrdiff_t>(part.stride()) * y);
  return part;
}

TEST_F(DebuggerIcicle, OperatorsOfTheLastStepsAreSeenInTheScene) {
  const auto differs_without_operators = [&] {
    EXPECT_EQ(driver().play("hover 5,400\nwait 3"), "");
    const Image with = view_of(driver());
    EXPECT_EQ(driver().play("click operators\nhover 5,400\nwait 3"), "");
    const Image without = view_of(driver());
    EXPECT_EQ(driver().play("click operators"), "");
    return with.rgba != without.rgba;
  };
  model().go(Position::end_of(run().position().step));
  ASSERT_FALSE(recent_operators(run()).empty());
  EXPECT_TRUE(differs_without_operators());
  model().go({});
  EXPECT_FALSE(differs_without_operators());
}

}  // namespace
}  // namespace kerf::test
