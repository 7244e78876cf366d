#include <gmock/gmock.h>

#include "tests/viz/debugger/timeline_driver.h"
#include "viz/debugger/model/opening.h"
#include "viz/debugger/panels/panel.h"

namespace kerf::test {
namespace {

StepRow row_with(std::uint32_t step, std::uint32_t leaves) {
  StepRow row;
  row.step = step;
  row.statistics.leaves = leaves;
  return row;
}

TEST(DebuggerOpening, IsTheFirstStepWithAGrownTree) {
  const std::vector<StepRow> rows{row_with(1, 1), row_with(2, 7), row_with(3, 8), row_with(4, 10),
                                  row_with(5, 9)};
  EXPECT_EQ(opening_step(rows), 3U);
  EXPECT_EQ(opening_step({}), 0U);
}

TEST(DebuggerWelcome, SaysWhatIsSeenUntilItIsClosed) {
  TimelineDriver driver;
  EXPECT_EQ(driver.play(R"(
expect welcome == no
expect step == 0
welcome
expect welcome == yes
expect step > 0
key Escape
expect welcome == no
key G
expect welcome == yes
click "close welcome"
expect welcome == no
click legend
expect welcome == yes
click "welcome tour"
expect welcome == no
expect tour == 1
)"),
            "");
}

bool is_shown(Debugger& debugger, const std::string& text) { return debugger.gui().find(text).has_value(); }

/// In 2D the areas of the leaves have the colours, and a drag moves the view.
TEST(DebuggerWelcome, SaysWhatColoursMeanInEachDimension) {
  TimelineDriver flat;
  ASSERT_EQ(flat.play("welcome\nwait 2"), "");
  EXPECT_TRUE(is_shown(flat.debugger(), "object: blue, or in the colour it was given"));
  EXPECT_TRUE(is_shown(flat.debugger(), "area of a leaf (see colour)"));
  EXPECT_FALSE(is_shown(flat.debugger(), "object, coloured as its leaf (see colour)"));
  const test::TemporaryRecording file;
  test::record_crowd<3>(file.path(), 20, test::busy_config());
  const std::unique_ptr<GlContext> context = make_offscreen_context();
  Debugger solid(*context, open_run(file.path()));
  ScriptPlayer(solid, 1280, 720, {}).play(parse_script("welcome\nwait 2"));
  EXPECT_TRUE(is_shown(solid, "object, coloured as its leaf (see colour)"));
  EXPECT_FALSE(is_shown(solid, "area of a leaf (see colour)"));
}

TEST(DebuggerTour, BeginsWithWhatIsSeenInEachDimension) {
  TimelineDriver flat;
  const std::string words = tour_text(flat.debugger().model(), 0);
  EXPECT_THAT(words, testing::HasSubstr("Drag to move it"));
  EXPECT_THAT(words, testing::Not(testing::HasSubstr("Objects are coloured as the leaves")));
  const test::TemporaryRecording file;
  test::record_crowd<3>(file.path(), 20, test::busy_config());
  DebuggerModel solid(open_run(file.path()));
  EXPECT_THAT(tour_text(solid, 0), testing::HasSubstr("Drag to turn it"));
  EXPECT_EQ(tour_text(solid, 1), tour_text(flat.debugger().model(), 1));
}

/// Seven stops, each of which frames a part of the window that is there.
TEST(DebuggerTour, LeadsThroughTheWindow) {
  TimelineDriver driver;
  EXPECT_EQ(driver.play(R"(
welcome
key F1
click tour
expect help == no
expect tour == 1
expect welcome == no   # it would hide the panel of later stops
expect step > 0
key Enter
expect tour == 2
click "next stop"
expect tour == 3
expect selection ~ n
key Enter
expect tour == 4
expect deed ~ "split"
key Enter
expect tour == 5
expect candidates > 1
click "stop before"
expect tour == 4
key Enter
key Enter
expect tour == 6
expect selection ~ pair
wait 2
expect explanation ~ "pair:"
key Enter
expect tour == 7
expect selection == nothing
click "next stop"
expect tour == none
key F1
click tour
key Escape
expect tour == none
)"),
            "");
}

/// One click selects; a drag turns the view and selects nothing.
TEST(DebuggerView, AClickSelectsAndADragDoesNot) {
  TimelineDriver driver;
  EXPECT_EQ(driver.play(R"(
click "go to"
type 20
key Enter
key Escape
click object:40
expect selection == "object 40"
wait 40
click object:113 shift
expect selection == "pair 40,113"
key Escape
wait 40
drag object:40 view@0.5,0.5
expect selection == nothing
wait 40
click node:0 ctrl
expect selection == n0
)"),
            "");
}

TEST(DebuggerView, TheMouseSaysWhatIsBelowIt) {
  TimelineDriver driver;
  EXPECT_EQ(driver.play(R"(
click "go to"
type 20
key Enter
key Escape
hover object:40
expect under_mouse ~ "object 40: "
expect under_mouse ~ "pair"
hover 5,5
expect under_mouse == nothing
click objects
hover node:0
expect under_mouse ~ n
)"),
            "");
}

/// Beside a compared run the right half is the other run's; its nodes are not those of this one.
TEST(DebuggerView, BesideAComparedRunTheMouseIsInOneOfTheTwo) {
  TimelineDriver driver;
  ASSERT_EQ(driver.play("click \"go to\"\ntype 20\nkey Enter\nkey Escape\nwait 2"), "");
  DebuggerModel& model = driver.debugger().model();
  model.compare_with(open_run(model.run().path()));
  ASSERT_EQ(driver.play("wait 2\nexpect comparing == yes"), "");
  const auto place = driver.debugger().view().place_of(ObjectId{40});
  ASSERT_TRUE(place);
  const PanelArea view = *driver.debugger().gui().find("view");
  const auto hover = [&](float x) {
    return driver.play("hover " + std::to_string(view.x + x) + "," + std::to_string(view.y + place->y) +
                       "\nexpect under_mouse ~ \"object 40: \"");
  };
  EXPECT_EQ(hover(place->x), "");
  EXPECT_EQ(hover(place->x + view.width / 2), "") << "the same run is seen there from the same place";
}

TEST(DebuggerView, AClickOnAPairsLineSelectsThePair) {
  TimelineDriver driver;
  ASSERT_EQ(driver.play("key End\nclick objects\nwait 2"), "");
  const SceneView& view = driver.debugger().view();
  const PanelArea area = *driver.debugger().gui().find("view");
  const auto pairs = driver.debugger().model().run().pairs();
  const auto seen = std::ranges::find_if(
      pairs, [&](const Pair& pair) { return view.place_of(pair.a) && view.place_of(pair.b); });
  ASSERT_NE(seen, pairs.end());
  const auto a = view.place_of(seen->a);
  const auto b = view.place_of(seen->b);
  EXPECT_EQ(driver.play("click " + std::to_string(area.x + (a->x + b->x) / 2) + "," +
                        std::to_string(area.y + (a->y + b->y) / 2) + "\nexpect selection ~ pair"),
            "");
}

TEST(DebuggerView, ThePairBelowTheMouseIsTheOneOfTheLine) {
  TimelineDriver driver;
  ASSERT_EQ(driver.play("key End\nwait 2"), "");
  const auto pairs = driver.debugger().model().run().pairs();
  ASSERT_FALSE(pairs.empty());
  const SceneView& view = driver.debugger().view();
  std::size_t found = 0;
  for (const Pair& pair : pairs) {
    const auto a = view.place_of(pair.a);
    const auto b = view.place_of(pair.b);
    if (!a || !b) continue;
    const auto there = view.pick_pair(double{a->x + b->x} / 2, double{a->y + b->y} / 2);
    found += there == pair ? 1U : 0U;
  }
  EXPECT_GT(2 * found, pairs.size()) << "others may lie on the same place";
  EXPECT_FALSE(view.pick_pair(-100, -100));
}

/// A second of playing is a second of the scene.
TEST(DebuggerTransport, PlaysByStepsAtTheSpeedOfTheScene) {
  TimelineDriver driver;
  EXPECT_EQ(driver.play("key Space\nwait 59\nexpect step >= 23\nexpect step <= 25"), "");
}

}  // namespace
}  // namespace kerf::test
