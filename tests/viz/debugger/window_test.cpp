// The window by mouse, keys and commands: panels that move, sizes, text and theme.

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "tests/support/default_window.h"
#include "tests/viz/debugger/timeline_driver.h"
#include "viz/draw/theme.h"

namespace kerf::test {
namespace {

class WindowOfDebugger : public testing::Test {
 protected:
  std::string play(const std::string& script, int width = 1280, int height = 720) {
    return driver_.play(script, width, height);
  }
  [[nodiscard]] Debugger& debugger() { return driver_.debugger(); }
  [[nodiscard]] const WindowLayout& layout() { return debugger().window().layout; }
  [[nodiscard]] PanelArea area(const std::string& name) {
    const auto found = debugger().gui().find(name);
    if (!found) ADD_FAILURE() << "there is no " << name;
    return found.value_or(PanelArea{});
  }
  [[nodiscard]] PanelPlace place(PanelId panel) { return layout().find(panel).value_or(CellIndex{}).place; }

 private:
  TimelineDriver driver_{40};
};

TEST_F(WindowOfDebugger, ADividerFollowsTheMouseAndADoubleClickBringsItBack) {
  EXPECT_EQ(play("drag \"divider left\" 400,300\nwait 1"), "");
  EXPECT_NEAR(area("panel view").x, 400, 1);
  EXPECT_NEAR(area("panel tree").width, 400, 1);
  EXPECT_EQ(play("drag \"divider below\" 640,420\nwait 1"), "");
  EXPECT_NEAR(area("panel timeline").y, 420, 1);
  EXPECT_EQ(play("drag \"divider right 1\" 1000,260\nwait 1"), "");
  EXPECT_NEAR(area("panel why").y, 260, 1);
  EXPECT_EQ(play("double \"divider left\"\ndouble \"divider below\"\ndouble \"divider right 1\"\nwait 2"),
            "");
  EXPECT_EQ(layout(), WindowLayout());
}

TEST_F(WindowOfDebugger, APanelIsDraggedByItsTitle) {
  EXPECT_EQ(play("drag \"panel tree\"@0.6,0.05 \"panel events\"@0.5,0.5\nwait 1"), "");
  EXPECT_EQ(layout().find(PanelId::tree), layout().find(PanelId::events));
  EXPECT_TRUE(layout().is_in_front(PanelId::tree));
  EXPECT_EQ(play("expect window ~ \"Events, Tree\"\nclick \"tab Events\"\nwait 1\nclick \"without objects\""),
            "");
  EXPECT_TRUE(layout().is_in_front(PanelId::events));
}

TEST_F(WindowOfDebugger, ATabIsDraggedToACellOfItsOwn) {
  EXPECT_EQ(play("drag \"tab Tables\" \"panel timeline\"@0.9,0.5\nwait 1"), "");
  EXPECT_EQ(place(PanelId::tables), PanelPlace::below);
  EXPECT_NEAR(area("panel tables").width, 640, 2);
  EXPECT_EQ(play("click \"tab Tables\"\nclick \"sort cost\"\nwait 1"), "") << "it works there";
}

TEST_F(WindowOfDebugger, ADragThatEndsInTheViewChangesNothing) {
  EXPECT_EQ(play("remember turned pictures\ndrag \"menu tree\" view\nwait 1"), "");
  EXPECT_EQ(layout(), WindowLayout());
}

TEST_F(WindowOfDebugger, ThePanelMenuMovesAndCloses) {
  EXPECT_EQ(play("click \"menu icicle\"\nclick \"menu right\"\nwait 1"), "");
  EXPECT_EQ(place(PanelId::icicle), PanelPlace::right);
  EXPECT_EQ(play("click \"menu icicle\"\nclick \"menu tab Tree\"\nwait 1"), "");
  EXPECT_EQ(layout().find(PanelId::icicle), layout().find(PanelId::tree));
  EXPECT_EQ(play("click \"menu icicle\"\nclick \"menu close\"\nwait 1"), "");
  EXPECT_FALSE(layout().is_open(PanelId::icicle));
  EXPECT_EQ(play("click window\nclick \"window icicle\"\nkey Escape\nwait 1"), "");
  EXPECT_TRUE(layout().is_open(PanelId::icicle));
  EXPECT_EQ(play("click window\nclick \"window reset\"\nwait 1"), "");
  EXPECT_EQ(layout(), WindowLayout());
}

TEST_F(WindowOfDebugger, CommandsDoTheSame) {
  const auto command = [&](const std::string& text) {
    EXPECT_EQ(play("key P\ntype \"" + text + "\"\nkey Enter\nwait 2"), "") << text;
  };
  command("close panel timeline");
  EXPECT_FALSE(layout().is_open(PanelId::timeline));
  command("show panel timeline");
  EXPECT_TRUE(layout().is_open(PanelId::timeline));
  command("panel tree: to the right");
  EXPECT_EQ(place(PanelId::tree), PanelPlace::right);
  command("panel why: tab beside breakpoints");
  EXPECT_EQ(place(PanelId::why), PanelPlace::left);
  const float before = area("panel view").x;
  command("left column: wider");
  EXPECT_GT(area("panel view").x, before);
  const float high = area("panel icicle").height;
  command("panel icicle: larger");
  EXPECT_GT(area("panel icicle").height, high);
  command("reset layout");
  EXPECT_EQ(layout(), WindowLayout());
  command("dark theme");
  EXPECT_EQ(play("expect theme == dark"), "");
  command("larger text");
  EXPECT_EQ(play("expect zoom == 1.1\nexpect scale == 1.1"), "");
  command("usual size of text");
  EXPECT_EQ(play("expect zoom == 1"), "");
}

TEST_F(WindowOfDebugger, TheMenuOfTheWindowIsUsedByKeys) {
  EXPECT_EQ(
      play("key F10\nwait 2\nkey Down\nkey Enter\nkey Escape\nwait 2\nexpect zoom != 1\nexpect help == no"),
      "");
  EXPECT_EQ(play("remember here position\nkey .\nexpect position != $here"), "") << "keys are free again";
}

TEST_F(WindowOfDebugger, WhatCanBeClickedCanBePressedByItsName) {
  const auto press = [&](const std::string& name) {
    EXPECT_EQ(play("key P\ntype \"press " + name + "\"\nkey Enter\nwait 2"), "") << name;
  };
  EXPECT_EQ(play("key End"), "");
  press("tab tables");
  EXPECT_TRUE(layout().is_in_front(PanelId::tables));
  press("sort depth");
  EXPECT_EQ(play("expect table_first != n0\nremember first table_first"), "");
  press("find in table");
  EXPECT_EQ(play("type leaf\nwait 1\nexpect table_rows > 1\nkey Escape"), "");
  press("granularity");
  EXPECT_EQ(play("key Down\nkey Down\nkey Enter\nwait 2"), "") << "a list that opens is gone through by keys";
  press("speed");
  EXPECT_EQ(play("type 50\nkey Enter\nwait 1"), "");
  EXPECT_NEAR(debugger().model().speed, 50, 1);
  press("menu icicle");
  EXPECT_EQ(play("key Down\nkey Enter\nwait 2"), "");
  EXPECT_NE(layout(), WindowLayout());
}

TEST_F(WindowOfDebugger, TheTourShowsPanelsThatWereClosed) {
  for (const PanelId panel : {PanelId::icicle, PanelId::events, PanelId::ballot})
    debugger().window().layout.close(panel);
  debugger().begin_tour();
  EXPECT_EQ(play("key Enter\nkey Enter\nkey Enter\nkey Enter\nwait 2\nexpect tour == 5"), "");
  for (const PanelId panel : {PanelId::icicle, PanelId::events, PanelId::ballot})
    EXPECT_TRUE(layout().is_in_front(panel)) << title_of(panel);
}

TEST_F(WindowOfDebugger, KeysZoomTexts) {
  EXPECT_EQ(play("remember lanes lanes_to\nkey ctrl+=\nkey ctrl++\nexpect zoom == 1.25\nkey ctrl+-\n"
                 "expect zoom == 1.1\nkey ctrl+0\nexpect zoom == 1\nexpect lanes_to == $lanes"),
            "");
}

TEST_F(WindowOfDebugger, TextsGrowOnlyAsFarAsTheWindowHasRoom) {
  for (int k = 0; k < 9; ++k) EXPECT_EQ(play("key ctrl+="), "");
  EXPECT_EQ(
      play("expect zoom == 3\nexpect scale > 1.2\nexpect scale < 1.6\nclick \"tab Ballot\"\nclick help\n"
           "expect help == yes\nkey Escape"),
      "");
  EXPECT_EQ(play("click \"menu timeline\"\nclick \"menu close\"\nwait 1\nexpect scale > 1.6"), "")
      << "without the lanes there is more room";
}

TEST_F(WindowOfDebugger, KeysTurnTheCamera) {
  EXPECT_EQ(play("wait 2\nremember before pictures\nkey ctrl+Left\nwait 2\nexpect pictures > $before\n"
                 "remember turned pictures\nkey ctrl+.\nwait 2\nexpect pictures > $turned\n"
                 "expect lanes_from == 0"),
            "");
}

/// Of a picture twice as fine, the colour of each pixel and its three neighbours.
Image halved(const Image& image) {
  Image half = make_image(image.width / 2, image.height / 2);
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x)
      for (int c = 0; c < 4; ++c) {
        int sum = 0;
        for (const auto& [dx, dy] : {std::pair(0, 0), std::pair(1, 0), std::pair(0, 1), std::pair(1, 1)})
          sum += image.pixel(2 * x + dx, 2 * y + dy)[c];
        half.rgba[half.stride() * static_cast<std::size_t>(y) + static_cast<std::size_t>(4 * x + c)] =
            static_cast<std::uint8_t>(sum / 4);
      }
  return half;
}

double mean_difference(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.rgba.size(); ++k) sum += std::abs(int{a.rgba[k]} - int{b.rgba[k]});
  return sum / static_cast<double>(a.rgba.size());
}

TEST_F(WindowOfDebugger, AScaleOfTwoIsTheSamePictureTwiceAsFine) {
  EXPECT_EQ(play("key End\nclick n1\nhover 5,300\nwait 2"), "");
  const auto names = debugger().gui().named();
  const Image coarse = debugger().picture();
  debugger().set_content_scale(2);
  EXPECT_EQ(play("hover 10,600\nwait 2\nexpect scale == 2", 2560, 1440), "");
  for (const auto& [name, place] : names) {
    const PanelArea now = area(name);
    EXPECT_NEAR(now.x, place.x, 1) << name;
    EXPECT_NEAR(now.y, place.y, 1) << name;
    EXPECT_NEAR(now.width, place.width, 1) << name;
  }
  EXPECT_LT(mean_difference(coarse, halved(debugger().picture())), 4);
}

/// How often a curve of the timeline begins or ends at each second pixel and at the others.
std::array<int, 2> count_edges(const Image& picture, const PanelArea& lanes, int scale) {
  constexpr int kClear = 60;  // the lines of the ruler are fainter
  std::array<int, 2> edges{};
  const auto first = static_cast<int>(lanes.x) * scale;
  for (int y = static_cast<int>(lanes.y) * scale; y < static_cast<int>(lanes.bottom()) * scale; ++y)
    for (int x = first + 1; x < static_cast<int>(lanes.right()) * scale; ++x) {
      const std::uint8_t* const a = picture.pixel(x - 1, y);
      const std::uint8_t* const b = picture.pixel(x, y);
      const int step = std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
      if (step > kClear) ++edges[static_cast<std::size_t>((x - first) % 2)];
    }
  return edges;
}

TEST(ScaleOfTheTimeline, IsThatOfTheDisplay) {
  TimelineDriver driver(240);
  driver.debugger().set_content_scale(2);
  EXPECT_EQ(driver.play("hover 10,600\nwait 2\nexpect scale == 2", 2560, 1440), "");
  const auto lanes = driver.debugger().gui().find("scrubber");
  ASSERT_TRUE(lanes);
  const auto [even, odd] = count_edges(driver.debugger().picture(), *lanes, 2);
  EXPECT_GT(even, 500);
  EXPECT_GT(2 * odd, even) << "columns of curves are two pixels wide";
}

/// A slider's usual grab lay over its text.
TEST_F(WindowOfDebugger, TheTextOfASliderIsFree) {
  for (const double speed : {2.0, 25.0, 80.0, 200.0}) {
    SCOPED_TRACE(speed);
    debugger().model().speed = speed;
    EXPECT_EQ(play("hover 10,600\nwait 2"), "");
    const PanelArea slider = area("speed");
    const Image& picture = debugger().picture();
    int blue = 0;
    for (int y = static_cast<int>(slider.y) + 2; y < static_cast<int>(slider.bottom()); ++y)
      for (int x = static_cast<int>(slider.x) + 3; x < static_cast<int>(slider.right()) - 3; ++x) {
        const std::uint8_t* const pixel = picture.pixel(x, y);
        const bool is_blue = pixel[2] - pixel[0] > 30;
        blue += is_blue ? 1 : 0;
        EXPECT_TRUE(!is_blue || y >= static_cast<int>(slider.bottom()) - 2) << x << ", " << y;
      }
    EXPECT_GT(blue, 3) << "it shows its value";
  }
}

TEST_F(WindowOfDebugger, AtEachScaleAllTabsFit) {
  const PanelArea panel = test::DefaultWindow(1280, 720).area(PanelId::why);
  for (const double scale : {0.75, 1.1, 1.25, 1.5, 1.75}) {
    SCOPED_TRACE(scale);
    debugger().set_content_scale(scale);
    EXPECT_EQ(play("wait 2", static_cast<int>(1280 * scale), static_cast<int>(720 * scale)), "");
    const PanelArea last = area("tab Tables");
    EXPECT_LT(last.right(), panel.right() - 15);
    EXPECT_GT(last.width, 40);
  }
}

TEST_F(WindowOfDebugger, AtEachScaleTheMouseIsWhereItPoints) {
  for (const double scale : {1.25, 2.0}) {
    SCOPED_TRACE(scale);
    debugger().set_content_scale(scale);
    EXPECT_EQ(play("key End\nkey Escape\nkey Escape\nwait 2\nclick object:3\nexpect selection ~ 3\nclick n1\n"
                   "expect selection == n1\ndrag \"divider left\" \"tab Why\"\nwait 1",
                   static_cast<int>(1280 * scale), static_cast<int>(720 * scale)),
              "");
    debugger().window().layout = WindowLayout();
  }
}

TEST_F(WindowOfDebugger, TheThemeColoursTheSceneAndThePanels) {
  const auto pixel = [&](const PanelArea& at) {
    const std::uint8_t* const p =
        debugger().picture().pixel(static_cast<int>(at.x) + 3, static_cast<int>(at.bottom()) - 3);
    return Color{p[0], p[1], p[2]};
  };
  for (const ThemeName name : {ThemeName::dark, ThemeName::light}) {
    debugger().window().theme = name;
    EXPECT_EQ(play("wait 2"), "");
    EXPECT_EQ(pixel(area("panel view")), theme_called(name).scene);
    EXPECT_EQ(pixel(area("panel transport")), theme_called(name).panel);
  }
}

}  // namespace
}  // namespace kerf::test
