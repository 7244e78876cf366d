#include <gtest/gtest.h>

#include "tests/support/recorded_crowd.h"
#include "viz/debugger/script.h"

namespace kerf {
namespace {

/// While only the scene changes, what is beside it is not drawn again; the picture must be as if it were.
class LayoutBesideScene : public testing::Test {
 protected:
  LayoutBesideScene() {
    test::record_crowd<3>(file_.path(), 60, test::busy_config());
    debugger_.emplace(*context_, open_run(file_.path()));
    play("key End\nwait 2");
  }

  void play(const std::string& script) {
    ScriptPlayer(*debugger_, kWidth, kHeight, {}).play(parse_script(script));
  }
  [[nodiscard]] int drawn_beside() { return std::stoi(debugger_->facts()["panel_pictures"]); }
  /// The picture that is there, then the same one, drawn from nothing.
  void expect_as_if_drawn_anew(const std::string& after) {
    const Image there = debugger_->picture();
    debugger_->forget_picture();
    debugger_->draw();
    EXPECT_EQ(there.rgba, debugger_->picture().rgba) << after;
  }
  Debugger& debugger() { return *debugger_; }

  static constexpr int kWidth = 1280;
  static constexpr int kHeight = 720;

 private:
  test::TemporaryRecording file_;
  std::unique_ptr<GlContext> context_ = make_offscreen_context();
  std::optional<Debugger> debugger_;
};

TEST_F(LayoutBesideScene, IsNotDrawnWhileTheCameraTurns) {
  DebuggerInput input;
  input.mouse_x = 500;
  input.mouse_y = 300;
  const auto frame = [&] { debugger().frame(input, kWidth, kHeight); };
  frame();
  input.buttons[0] = true;
  frame();
  frame();
  const int beside = drawn_beside();
  const std::string scene = debugger().facts()["pictures"];
  for (int k = 0; k < 10; ++k) {
    input.mouse_x += 5;
    frame();
  }
  EXPECT_GE(std::stoi(debugger().facts()["pictures"]), std::stoi(scene) + 9);
  EXPECT_EQ(drawn_beside(), beside);
  input.key = Key::period;
  frame();
  EXPECT_EQ(drawn_beside(), beside + 1);
}

TEST_F(LayoutBesideScene, ThePictureIsAsIfAllOfItWereDrawn) {
  for (const double scale : {1.0, 1.3}) {
    debugger().set_content_scale(scale);
    for (const std::string script :
         {"wait 2", "drag view@0.4,0.5 view@0.5,0.6", "wheel 4", "hover object:3", "hover view@0.02,0.98",
          "key .", "click object:3", "drag view@0.6,0.5 view@0.3,0.4", "key F1", "wheel -3\nwait 2",
          "key Escape", "welcome", "drag view@0.5,0.9 view@0.4,0.9", "key Escape", "hover \"tab Ballot\""}) {
      play(script);
      expect_as_if_drawn_anew(script + " at " + std::to_string(scale));
    }
  }
}

}  // namespace
}  // namespace kerf
