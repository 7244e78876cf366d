// The debugger shows another engine's structure in the place of ours, with what is wrong with it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/query/their_parts.h"
#include "tests/support/dimensions.h"
#include "tests/support/recorded_crowd.h"
#include "tests/viz/debugger/timeline_driver.h"
#include "viz/debugger/model/run_of.h"
#include "viz/debugger/window/arrangement.h"

namespace kerf {
namespace {

using testing::HasSubstr;

constexpr std::uint32_t kSteps = 12;
constexpr std::uint32_t kWrong = 8;  // in this step the root is not refitted
constexpr std::uint32_t kFirst = 3;  // before it no structure is known

/// A root, and below it a leaf for each object.
template <int D>
TheirStructure<D> structure_of(const ObjectTable<D>& objects, bool is_wrong) {
  TheirStructure<D> structure;
  structure.nodes.push_back({GivenId::of(500), std::nullopt, Box<D>::empty(), {}, std::nullopt, 0});
  for_each_placed(objects, [&](ObjectId object) {
    const Box<D> box = objects.box(object);
    structure.nodes.push_back(
        {GivenId::of(1000 + object.value), GivenId::of(500), box, {object}, std::nullopt, 0});
    Box<D>& root = structure.nodes.front().box;
    if (!is_wrong || structure.nodes.size() < 4) root = join(root, box);
  });
  return structure;
}

template <class T>
class DebuggerTheirs : public testing::Test {
 protected:
  static constexpr int kDimension = T::value;

  DebuggerTheirs() {
    Bsp<kDimension, EventLog> tree(test::busy_config());
    RecordingInfo info = test::info_of<kDimension>(test::busy_config());
    info.imported = true;
    Recorder<kDimension> recorder(tree, file_.path(), info);
    test::play_crowd<kDimension>(recorder, kSteps, 3, [&](std::uint32_t step) {
      const auto structure = structure_of<kDimension>(tree.objects(), step == kWrong);
      if (step >= kFirst) recorder.add_theirs(structure);
      nodes_.push_back(structure.nodes.size());
    });
    recorder.finish();
  }
  std::string play(const std::string& script) {
    Debugger debugger(*context_, open_run(file_.path()));
    return test::played(debugger, script);
  }

  std::unique_ptr<GlContext> context_ = make_offscreen_context();
  test::TemporaryRecording file_;
  std::vector<std::size_t> nodes_;  ///< by step, from 1 on
};
TYPED_TEST_SUITE(DebuggerTheirs, test::Dimensions, test::DimensionNames);

TYPED_TEST(DebuggerTheirs, AreDrawnInThePlaceOfOursAndFollowTheSteps) {
  EXPECT_EQ(this->play(R"(
key End
expect structure == ours
expect drawn_partitioners > 0
click structure
wait 2
click "structure theirs"
wait 2
expect structure == theirs
expect drawn_partitioners == 0
expect their_faults == 0
expect their_nodes == )" +
                       std::to_string(this->nodes_.back()) +
                       R"(
expect drawn_nodes_of_theirs == )" +
                       std::to_string(this->nodes_.back()) + R"(
expect labels == ""
click "go to"
type 1
key Enter
expect their_nodes == 0
click structure
wait 2
click "structure ours"
wait 2
expect structure == ours
)"),
            "");
}

TYPED_TEST(DebuggerTheirs, FaultsAreListedAndLeadToTheirStep) {
  EXPECT_EQ(this->play(R"(
key End
click structure
wait 2
click "structure theirs"
wait 2
click "tab Lint"
wait 3
click "fault 0"
wait 3
expect step == 8
expect their_faults > 0
expect labels ~ "lies outside its parent n500"
)"),
            "");
}

/// A pair's explanation goes on in their nodes, where their search ends.
TYPED_TEST(DebuggerTheirs, WhyEndsAtTheirNode) {
  constexpr int kD = TestFixture::kDimension;
  RunOf<kD> run(this->file_.path());
  run.go(Position::end_of(kWrong));
  ASSERT_FALSE(run.their_faults().empty());
  ASSERT_FALSE(run.pairs().empty());
  bool ends = false;
  for (const Pair& pair : run.pairs())
    ends |= run.explain(make_pair(pair.a, pair.b)).find(" ends at n500") != std::string::npos;
  EXPECT_TRUE(ends);
  run.go(Position::end_of(kFirst - 1));
  EXPECT_EQ(run.their_nodes(), 0U);
  EXPECT_THAT(run.explain(run.pairs()[0]), testing::Not(HasSubstr("other engine's structure")));
}

/// However narrow the window is: the choice is as high as its neighbour, so no part of it is cut off.
TYPED_TEST(DebuggerTheirs, TheChoiceIsWholeWithinTheToolsAtEveryWidth) {
  Debugger debugger(*this->context_, open_run(this->file_.path()));
  for (int width = kLeastDebuggerWidth; width <= 1920; width += 40) {
    SCOPED_TRACE(width);
    ScriptPlayer(debugger, width, kLeastDebuggerHeight, {}).play(parse_script("key End\nwait 3"));
    const auto choice = debugger.gui().find("structure");
    const auto neighbour = debugger.gui().find("colour");
    ASSERT_TRUE(choice && neighbour);
    const PanelArea tools = arrange(WindowLayout(), {static_cast<float>(width),
                                                     static_cast<float>(kLeastDebuggerHeight), 0, true})
                                .tools;
    EXPECT_EQ(choice->height, neighbour->height);
    EXPECT_GE(choice->x, tools.x);
    EXPECT_LT(choice->x + choice->width, tools.x + tools.width);
    EXPECT_LT(choice->y + choice->height, tools.y + tools.height);
  }
}

TEST(DebuggerTheirsAlone, ARunWithoutAStructureHasNoChoice) {
  const test::TemporaryRecording file;
  test::record_crowd<2>(file.path(), 3, test::busy_config());
  const auto context = make_offscreen_context();
  Debugger debugger(*context, open_run(file.path()));
  EXPECT_THROW(ScriptPlayer(debugger, 1280, 720, {}).play(parse_script("wait 2\nclick structure")),
               ScriptError);
  ScriptPlayer(debugger, 1280, 720, {}).play(parse_script("expect structure == \"ours alone\""));
}

}  // namespace
}  // namespace kerf
