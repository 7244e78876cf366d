#include <gmock/gmock.h>

#include <optional>

#include "core/replay/judge_theirs.h"
#include "core/replay/oracle.h"
#include "tests/support/recorded_crowd.h"
#include "viz/debugger/script.h"

namespace kerf {
namespace {

constexpr std::uint32_t kSteps = 60;

/// The debugger on a crowd of so many steps.
class TimelineDriver {
 public:
  explicit TimelineDriver(std::uint32_t steps = kSteps) {
    Bsp<2, EventLog> tree(test::busy_config());
    Recorder<2> recorder(tree, file_.path(), test::info_of<2>(test::busy_config()));
    test::play_crowd<2>(recorder, steps, 3, [](std::uint32_t) {});
    recorder.finish();
    debugger_.emplace(*context_, open_run(file_.path()));
  }
  /// An import whose steps have names.
  explicit TimelineDriver(const std::vector<std::string>& names) {
    Bsp<2, EventLog> tree(test::busy_config());
    RecordingInfo info = test::info_of<2>(test::busy_config());
    info.imported = true;
    info.names = GivenNames({}, names);
    Recorder<2> recorder(tree, file_.path(), info);
    test::play_crowd<2>(recorder, static_cast<std::uint32_t>(names.size()), 3, [&](std::uint32_t) {
      const std::vector<Pair> truth = oracle_pairs(tree.objects());
      recorder.add_theirs(truth, judge_theirs<2>(truth, truth, tree.objects(), TheirWorld<2>(), {}));
    });
    recorder.finish();
    debugger_.emplace(*context_, open_run(file_.path()));
  }

  /// What the script failed with; empty if it did not.
  std::string play(const std::string& script, int width = 1280, int height = 720) {
    try {
      ScriptPlayer(*debugger_, width, height, {}).play(parse_script(script));
    } catch (const ScriptError& error) {
      return error.what();
    }
    return "";
  }
  [[nodiscard]] Debugger& debugger() { return *debugger_; }

 private:
  test::TemporaryRecording file_;
  std::unique_ptr<GlContext> context_ = make_offscreen_context();
  std::optional<Debugger> debugger_;
};

TEST(TimelinePanel, TheWheelZoomsAtTheMouseAndPansSideways) {
  TimelineDriver driver;
  EXPECT_EQ(driver.play(R"(
expect lanes_from == 0
expect lanes_to == 60
hover scrubber@0.25,0.5
wheel 4
expect lanes_from > 0
expect lanes_to < 60
expect lanes_to > 33
drag scrubber@0.25,0.5 scrubber@0.25,0.5
expect step == 15          # what was under the mouse is there still
remember from lanes_from
wheel -1 shift
expect lanes_from > $from
wheel 1 shift
expect lanes_from == $from
wheel -1 sideways
expect lanes_from > $from
wheel 1 sideways
expect lanes_from == $from
wheel -40
expect lanes_from == 0
expect lanes_to == 60
)"),
            "");
}

TEST(TimelinePanel, ARightOrMiddleDragPansAndALeftOneScrubs) {
  TimelineDriver driver;
  EXPECT_EQ(driver.play(R"(
hover scrubber@0.5,0.5
wheel 5
remember from lanes_from
remember to lanes_to
drag scrubber@0.5,0.5 scrubber@0.3,0.5 right
expect step == 0
expect lanes_from > $from
expect lanes_to > $to
drag scrubber@0.3,0.5 scrubber@0.5,0.5 middle
expect step == 0
expect lanes_from == $from
drag scrubber@0.2,0.5 scrubber@0.5,0.5
expect step == 30
expect lanes_from == $from
)"),
            "");
}

TEST(TimelinePanel, TheMinimapShowsAndMovesTheWindow) {
  TimelineDriver driver;
  EXPECT_EQ(driver.play(R"(
key +
key +
expect lanes_from == 0
expect lanes_to == 15
click minimap@0.5,0.5     # beside the window: it comes there
expect lanes_from == 22.5
expect lanes_to == 37.5
drag minimap@0.5,0.5 minimap@0.75,0.5
expect lanes_from > 37
expect lanes_from < 38
expect step == 0
hover minimap@0.5,0.5
wheel -40
expect lanes_to == 60
)"),
            "");
}

TEST(TimelinePanel, AllOfItCanBeDoneByKeys) {
  TimelineDriver driver;
  EXPECT_EQ(driver.play(R"(
key shift+.
key +
key +
expect lanes_to == 15.75
key Right
expect lanes_from > 2
key Left
expect lanes_from < 2
key R
expect lanes_to == 60
key +
key -
expect lanes_to == 60
click "zoom in"
expect lanes_to < 60
click "whole run"
expect lanes_to == 60
expect lane == operators
key Down
expect lane == pairs
key M
remember most lane_max
expect pairs == $most
key shift+M
remember least lane_min
expect pairs == $least
key Up
key Up
expect lane == deferred
key Down
expect lane == operators
)"),
            "");
}

TEST(TimelinePanel, ExtremesAreShownAndAClickGoesThere) {
  TimelineDriver driver;
  EXPECT_EQ(driver.play(R"(
click "max pairs"
expect lane == pairs
remember most lane_max
expect pairs == $most
click "min pairs"
remember least lane_min
expect pairs == $least
expect pairs != $most
)"),
            "");
  EXPECT_EQ(driver.play("click \"lane height\"\nexpect lane == height"), "");
}

TEST(TimelinePanel, SingleEventsAreGoneToWhereTheyAreApart) {
  TimelineDriver driver;
  EXPECT_EQ(driver.play(R"(
key shift+.
key shift+.
key shift+.
hover scrubber@0.5,0.5
key +
key +
key +
key +
key +
key +
key +
key +
key +
key +
key +
key +
drag scrubber@0.3,0.5 scrubber@0.2,0.5
expect event != none
remember event event
drag scrubber@0.2,0.5 scrubber@0.5,0.5
expect event != $event
)"),
            "");
}

TEST(TimelinePanel, TheLanesFollowTheMoment) {
  TimelineDriver driver;
  EXPECT_EQ(driver.play(R"(
key +
key +
key +
expect lanes_to == 7.5
key End
expect lanes_to == 60
expect lanes_from == 52.5
key Home
expect lanes_from == 0
)"),
            "");
}

TEST(TimelinePanel, StepsAreNamedAsTheOtherEngineNamesThem) {
  std::vector<std::string> names;
  for (int k = 0; k < 12; ++k) names.push_back(std::to_string(5000 + 2 * k));
  TimelineDriver driver(names);
  EXPECT_EQ(driver.play(R"(
drag scrubber@0,0.5 scrubber@0.5,0.5
expect step == 5010
key +
key +
expect lanes_from == 4.5
key End
expect step == 5022
)"),
            "");
}

TEST(TimelinePanel, AnEmptyRunAndOneOfAStepHaveLanes) {
  for (const std::uint32_t steps : {0U, 1U}) {
    SCOPED_TRACE(steps);
    TimelineDriver driver(steps);
    EXPECT_EQ(driver.play(R"(
expect lanes_from == 0
expect lanes_to == 1
hover scrubber@0.5,0.5
wheel 5
wheel -5
wheel 2 shift
drag scrubber@0,0.5 scrubber@1,0.5
drag scrubber@0.2,0.5 scrubber@0.5,0.5 right
click minimap@0.9,0.5
key +
key -
key R
key M
key shift+M
click "max operators"
click "min step ms"
key Left
key C
expect message !~ nan
expect lane_max !~ nan
expect lane_scale !~ nan
)"),
              "");
    EXPECT_EQ(driver.play("expect step == " + std::to_string(steps)), "");
    EXPECT_EQ(driver.play(steps == 0 ? "expect lane_max == none" : "expect lane_max != none"), "");
  }
}

TEST(TimelinePanel, KeysAndButtonsGoToEachKindOfMoment) {
  TimelineDriver driver;
  EXPECT_EQ(driver.play(R"(
key 3
expect deed ~ split
remember first event
key 3
expect event != $first
key shift+3
expect event == $first
key shift+3
expect event == $first
expect message == "nothing of the kind 'split' further back"
key 1
expect kind == balance
expect deed ~ balance
key n
expect deed ~ balance
remember balance event
click "next of kind"
expect event != $balance
click "previous of kind"
expect event == $balance
click kind
click "kind placed"
expect kind == placed
key n
expect event != $balance
key shift+n
expect event != $balance
key K
expect kind == phase
key n
expect deed ~ phase
key Home
key B
key End
key B
key shift+0
expect step == 0
key 0
expect step == 60
key 9
expect message == "nothing of the kind 'alarm' further on"
)"),
            "");
}

/// Of every size: parts lie within the panel, and none lies over another.
TEST(TimelinePanel, PartsDoNotOverlap) {
  for (const auto& [width, height] : {std::pair(960, 600), std::pair(1280, 720), std::pair(1920, 1080)}) {
    SCOPED_TRACE(width);
    TimelineDriver driver;
    EXPECT_EQ(driver.play("key End\nhover 5,300\nwait 2", width, height), "");
    const PanelArea panel = layout_panels(width, height).timeline;
    std::vector<std::pair<std::string, PanelArea>> parts;
    for (const auto& [name, area] : driver.debugger().gui().named())
      if (area.y >= panel.y) parts.emplace_back(name, area);
    ASSERT_GT(parts.size(), 20U);
    for (const auto& [name, area] : parts) {
      EXPECT_GE(area.x, panel.x) << name;
      EXPECT_LE(area.x + area.width, panel.x + panel.width) << name;
      EXPECT_LE(area.y + area.height, panel.y + panel.height) << name;
      for (const auto& [other, place] : parts) {
        const bool apart = area.x + area.width <= place.x || place.x + place.width <= area.x ||
                           area.y + area.height <= place.y || place.y + place.height <= area.y;
        EXPECT_TRUE(apart || name == other) << name << " and " << other;
      }
    }
  }
}

}  // namespace
}  // namespace kerf
