#define GLFW_INCLUDE_NONE
#include "viz/debugger/window_loop.h"

#include <GLFW/glfw3.h>
#include <gmock/gmock.h>

#include <array>

#include "tests/support/recorded_crowd.h"
#include "tests/viz/debugger/x_display.h"

namespace kerf {
namespace {

/// A debugger in a window on a display without a screen.
class DebuggerWindow : public testing::Test {
 protected:
  DebuggerWindow() {
    test::record_crowd<2>(file_.path(), 120, test::busy_config());
    window_.emplace("kerf", 1280, 720);
    debugger_.emplace(*window_, open_run(file_.path()));
    loop_.emplace(*window_, *debugger_);
    (void)frames_until_rest();
  }

  /// Turns until a hint would have been drawn; how often it drew.
  int frames_until_rest() {
    constexpr double kPatience = Pace::kRest + 0.15;
    int frames = 0;
    for (double rests = window_->seconds() + kPatience; window_->seconds() < rests;) {
      if (!loop_->turn()) continue;
      ++frames;
      rests = window_->seconds() + kPatience;
    }
    return frames;
  }
  /// What was posted until here comes in one poll.
  void take_in() {
    display_.flush();
    (void)frames_until_rest();
  }
  /// A key while another one is held.
  void tap(const std::string& key, const std::string& held) {
    display_.hold(held);
    display_.tap(key);
    display_.let_go(held);
  }
  void move_to(const std::string& name, float share = 0.5F) {
    const auto area = debugger_->gui().find(name);
    ASSERT_TRUE(area) << name;
    display_.move(area->x + share * area->width, area->y + 0.5F * area->height);
  }
  [[nodiscard]] std::string fact(const std::string& name) { return debugger_->facts()[name]; }

  test::XDisplay display_;
  std::optional<GlfwWindow> window_;
  std::optional<Debugger> debugger_;
  std::optional<WindowLoop> loop_;

 private:
  test::TemporaryRecording file_;
};

TEST_F(DebuggerWindow, SeesAHundredClicksOfNoTime) {
  move_to("step forward");
  for (int k = 0; k < 100; ++k) display_.click(1);
  take_in();
  EXPECT_EQ(fact("step"), "100");
}

TEST_F(DebuggerWindow, SeesWhereAScrubEnds) {
  move_to("scrubber", 0.1F);
  display_.press(1);
  move_to("scrubber", 0.75F);
  display_.release(1);
  move_to("scrubber", 0.3F);
  take_in();
  EXPECT_EQ(fact("step"), "90");
}

TEST_F(DebuggerWindow, SeesCtrlWithSignsAndDigits) {
  const auto tap_with_control = [&](const std::string& key) {
    display_.hold("Control_L");
    display_.tap(key);
    display_.let_go("Control_L");
    take_in();
  };
  tap_with_control("equal");
  tap_with_control("equal");
  EXPECT_EQ(fact("zoom"), "1.25");
  tap_with_control("minus");
  EXPECT_EQ(fact("zoom"), "1.1");
  tap_with_control("0");
  EXPECT_EQ(fact("zoom"), "1");
}

TEST(ScaledWindow, GrowsAndDrawsFinerOnAFineDisplay) {
  test::XDisplay display;
  display.set_dots_per_inch(144);
  const test::TemporaryRecording file;
  test::record_crowd<2>(file.path(), 20, test::busy_config());
  GlfwWindow window("kerf", 960, 600, true);
  EXPECT_DOUBLE_EQ(window.content_scale(), 1.5);
  EXPECT_EQ(window.width(), 1440);
  Debugger debugger(window, open_run(file.path()));
  WindowLoop loop(window, debugger);
  while (!loop.turn()) continue;
  EXPECT_DOUBLE_EQ(debugger.scale(), 1.5);
  WindowLoop asked(window, debugger, 1);
  while (!asked.turn()) continue;
  EXPECT_DOUBLE_EQ(debugger.scale(), 1) << "the scale that was asked for counts";
}

TEST_F(DebuggerWindow, SeesKeysAndLettersInTheirOrder) {
  for (int k = 0; k < 40; ++k) display_.tap("b");
  take_in();
  EXPECT_EQ(fact("bookmarks"), "0");
  move_to("go to");
  display_.click(1);
  for (const char* const key : {"9", "o", "5", "Left", "BackSpace", "Return", "b"}) display_.tap(key);
  take_in();
  EXPECT_EQ(fact("position"), "step 95");
  EXPECT_EQ(fact("bookmarks"), "1");
}

TEST_F(DebuggerWindow, SeesEveryTurnOfTheWheel) {
  display_.move(640, 360);
  for (int k = 0; k < 12; ++k) display_.click(4);
  take_in();
  const std::string once = fact("pictures");
  for (int k = 0; k < 12; ++k) display_.click(5);
  take_in();
  EXPECT_NE(fact("pictures"), once) << "zoomed out again";
  const Image back = debugger_->picture();
  display_.click(4);
  display_.click(5);
  take_in();
  EXPECT_EQ(debugger_->picture().rgba, back.rgba);
}

TEST_F(DebuggerWindow, SeesTheKeysAndTheWheelsOfTheLanes) {
  for (const char* const key : {"KP_Add", "KP_Add", "KP_Add", "minus", "Down"}) display_.tap(key);
  take_in();
  EXPECT_EQ(fact("lanes_to"), "30");
  EXPECT_EQ(fact("lane"), "pairs");
  move_to("scrubber");
  display_.click(7);  // a wheel to the right
  display_.click(7);
  take_in();
  EXPECT_EQ(fact("lanes_from"), "6");
  display_.click(6);
  take_in();
  EXPECT_EQ(fact("lanes_from"), "3");
  for (const char* const key : {"3", "s", "e", "l"}) display_.tap(key);
  take_in();
  EXPECT_THAT(fact("deed"), testing::HasSubstr("split"));
  EXPECT_THAT(fact("range"), testing::HasSubstr("1 step: "));
  EXPECT_EQ(fact("loops"), "yes");
}

TEST_F(DebuggerWindow, OpensAFileThatIsDroppedOnIt) {
  const test::TemporaryRecording other;
  test::record_crowd<3>(other.path(), 30, test::busy_config());
  const std::string path = other.path().string();
  std::array<const char*, 2> paths{path.c_str(), "another"};
  GLFWwindow* const window = glfwGetCurrentContext();
  const GLFWdropfun dropped = glfwSetDropCallback(window, nullptr);
  ASSERT_NE(dropped, nullptr);
  dropped(window, 2, paths.data());
  take_in();
  EXPECT_EQ(fact("steps"), "30");
  EXPECT_EQ(fact("message"), "opened " + path);
  EXPECT_NE(fact("drawn_objects"), "0");
}

TEST_F(DebuggerWindow, TakesBackCopiesAndPastes) {
  display_.tap("KP_Add");
  display_.tap("KP_Add");
  take_in();
  EXPECT_EQ(fact("lanes_to"), "30");
  tap("z", "Control_L");
  take_in();
  EXPECT_EQ(fact("lanes_to"), "120");
  window_->copy("pasted\n");
  tap("b", "Shift_L");
  take_in();
  tap("v", "Control_L");
  display_.tap("Return");
  take_in();
  EXPECT_EQ(fact("note0"), "pasted") << "without the letter of the key";
  move_to("panel transport");
  tap("c", "Control_L");
  take_in();
  EXPECT_THAT(window_->clipboard(), testing::HasSubstr("before the first step, of 120 steps"));
}

/// At rest it used to draw 20 frames a second, half a core without a graphics card.
TEST_F(DebuggerWindow, SeesTheKeysOfTheTreeAndFillsTheClipboard) {
  for (const char* const key : {"d", "d", "x", "u", "a", "t"}) display_.tap(key);
  take_in();
  EXPECT_EQ(fact("selection"), "n0");
  EXPECT_EQ(fact("icicle"), "before");
  move_to("copy table");
  display_.click(1);
  take_in();
  EXPECT_THAT(window_->clipboard(), testing::HasSubstr("node,depth,population"));
  EXPECT_EQ(window_->clipboard(), fact("copied"));
}

TEST_F(DebuggerWindow, DrawsNothingWhenNothingMoves) {
  display_.move(640, 360);
  display_.flush();
  EXPECT_GT(frames_until_rest(), 0);
  int frames = 0;
  for (const double end = window_->seconds() + 3; window_->seconds() < end;) frames += loop_->turn() ? 1 : 0;
  EXPECT_EQ(frames, 0);
}

TEST_F(DebuggerWindow, AHintComesThoughTheMouseRests) {
  move_to("step forward");
  take_in();
  const Image hint = debugger_->picture();
  debugger_->frame({}, 1280, 720);
  debugger_->frame({}, 1280, 720);
  std::size_t different = 0;
  const Image without = debugger_->picture();
  for (std::size_t k = 0; k < hint.rgba.size(); ++k) different += hint.rgba[k] != without.rgba[k] ? 1U : 0U;
  EXPECT_GT(different, 3000U) << "more than the button's own colour";
}

/// At one step in a quarter of a second; a busy machine may be late, but neither ahead nor at a stand.
TEST_F(DebuggerWindow, PlaysAtItsSpeedWithoutInput) {
  debugger_->model().speed = 4;
  display_.tap("space");
  display_.flush();
  const double start = window_->seconds();
  int frames = 0;
  while (window_->seconds() < start + 3) frames += loop_->turn() ? 1 : 0;
  const double steps = debugger_->model().run().position().step;
  EXPECT_LE(steps, 4 * (window_->seconds() - start) + 1);
  EXPECT_GE(steps, 3);
  // The key goes down and up, each in a frame of its own that then settles; a hint and what a busy window
  // system asks for may be drawn.
  constexpr int kOthers = 4;
  EXPECT_LE(frames, steps + 2 * (1 + Pace::kSettling) + kOthers) << "a frame for each step";
}

}  // namespace
}  // namespace kerf
