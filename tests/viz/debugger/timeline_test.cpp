#include <gmock/gmock.h>

#include "tests/support/default_window.h"
#include "tests/viz/debugger/timeline_driver.h"

namespace kerf::test {
namespace {

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
remember from lanes_from
hover minimap@0.3,0.5
hover minimap@0.6,0.5
expect lanes_from == $from
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

TEST(TimelinePanel, ALongRunIsSeenAsAWholeAndByEvents) {
  TimelineDriver driver(test::LongRun{100'000});
  EXPECT_EQ(driver.play(R"(
expect lanes_to == 100000
hover scrubber@0.5,0.5
wheel 80
expect lanes_from > 49998
expect lanes_to < 50002
drag scrubber@0.3,0.5 scrubber@0.4,0.5
expect event != none
expect step > 49998
expect step < 50002
key End
expect lanes_to == 100000
expect lanes_from > 99990
wheel -80
expect lanes_from == 0
drag scrubber@0.2,0.5 scrubber@0.6,0.5 shift
expect range ~ "pairs 1; height 0;"
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
key S
key E
key L
key Space
wait 20
drag scrubber@0.2,0.5 scrubber@0.5,0.5 shift
expect range !~ nan
key Escape
expect message !~ nan
expect lane_max !~ nan
expect lane_scale !~ nan
)"),
              "");
    EXPECT_EQ(driver.play("key End\nexpect step == " + std::to_string(steps)), "");
    EXPECT_EQ(driver.play(steps == 0 ? "expect lane_max == none" : "expect lane_max != none"), "");
  }
}

/// A step of 120 has ten times the redundancy of the others.
constexpr const char* kOutliers =
    "UPDATE steps SET redundancy = 0.01; UPDATE steps SET redundancy = 0.1 WHERE step = 7";

TEST(TimelinePanel, ALaneWithOutliersSaysSoAndShowsThemOnRequest) {
  TimelineDriver driver(120, kOutliers);
  EXPECT_EQ(driver.play(R"(
click "lane redundancy %"
expect lane_above == 1
expect lane_scale == 1
expect lane_max == 10
click "1 above p99"
expect lane_above == 0
expect lane_scale == 10
key C
expect lane_above == 1
key M
expect step == 7
)"),
            "");
}

/// Of every size: parts lie within the panel, and none lies over another.
TEST(TimelinePanel, PartsDoNotOverlap) {
  for (const auto& [width, height] : {std::pair(960, 600), std::pair(1280, 720), std::pair(1920, 1080)}) {
    SCOPED_TRACE(width);
    TimelineDriver driver(120, kOutliers);
    driver.debugger().model().select(ObjectId{3});  // which has lanes, too
    EXPECT_EQ(driver.play("drag scrubber@0.1,0.5 scrubber@0.9,0.5 shift\nkey End\nhover 5,300\nwait 2", width,
                          height),
              "");
    const PanelArea panel = test::DefaultWindow(width, height, kLanesOfRun + 3).area(PanelId::timeline);
    std::vector<std::pair<std::string, PanelArea>> parts;
    for (const auto& [name, area] : driver.debugger().gui().named())
      if (area.y >= panel.y && !name.starts_with("panel ") && !name.starts_with("divider "))
        parts.emplace_back(name, area);
    const auto figures = driver.debugger().gui().find("range figures");
    ASSERT_TRUE(figures);
    parts.emplace_back("range figures", *figures);
    ASSERT_GT(parts.size(), 25U);
    for (const auto& [name, area] : parts) {
      EXPECT_GE(area.x, panel.x) << name;
      EXPECT_GE(area.height, name.starts_with("lane ") ? 12 : 1) << name;  // letters fit
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
}  // namespace kerf::test
