#include <gmock/gmock.h>

#include <optional>

#include "tests/support/default_window.h"
#include "tests/support/recorded_crowd.h"
#include "viz/debugger/script.h"

namespace kerf {
namespace {

/// The debugger in the smallest size that it promises.
class LeastSize : public testing::Test {
 protected:
  LeastSize() {
    test::record_crowd<3>(file_.path(), 60, test::busy_config());
    debugger_.emplace(*context_, open_run(file_.path()));
  }

  void play(const std::string& script) {
    ScriptPlayer(*debugger_, kLeastDebuggerWidth, kLeastDebuggerHeight, {}).play(parse_script(script));
  }
  [[nodiscard]] PanelArea part(const std::string& name) const {
    const auto area = debugger_->gui().find(name);
    if (!area) ADD_FAILURE() << "there is no " << name;
    return area.value_or(PanelArea{});
  }
  [[nodiscard]] Debugger& debugger() { return *debugger_; }

 private:
  test::TemporaryRecording file_;
  std::unique_ptr<GlContext> context_ = make_offscreen_context();
  std::optional<Debugger> debugger_;
};

const test::DefaultWindow kWindow(kLeastDebuggerWidth, kLeastDebuggerHeight);

constexpr const char* kGoToSplit =
    "click condition\ntype \"op==split && kind==acted && step>20\"\nkey Enter\nkey Escape\nkey F5\nwait 2\n";

void expect_within(const PanelArea& part, const PanelArea& panel, const std::string& what) {
  EXPECT_GE(part.x, panel.x) << what;
  EXPECT_GE(part.y, panel.y) << what;
  EXPECT_LE(part.x + part.width, panel.x + panel.width) << what;
  EXPECT_LE(part.y + part.height, panel.y + panel.height) << what;
}

TEST_F(LeastSize, EveryTabCanBePressed) {
  EXPECT_NO_THROW(play(kGoToSplit));
  const PanelArea panel = kWindow.area(PanelId::why);
  for (const char* const name :
       {"Tables", "Lint", "Compare", "What if", "Oracle", "Algorithm", "Ballot", "Why"}) {
    EXPECT_NO_THROW(play("click \"tab " + std::string(name) + "\"\nwait 2"));
    for (const char* const other :
         {"Why", "Ballot", "Algorithm", "Oracle", "What if", "Compare", "Lint", "Tables"})
      expect_within(part("tab " + std::string(other)), panel, std::string(other) + " beside " + name);
  }
}

TEST_F(LeastSize, ToolsOfTheViewAreWithinTheirPanel) {
  play("wait 2");
  const PanelArea panel = kWindow.all().tools;
  for (const std::string name : {"objects", "operators", "colour", "focus", "show all", "depth"})
    expect_within(part(name), panel, name);
}

/// And in all that are wider: each is as high as the others, so none is cut off.
TEST_F(LeastSize, ToolsOfTheViewAreWholeAtEveryWidth) {
  for (int width = kLeastDebuggerWidth; width <= 1920; width += 40) {
    ScriptPlayer(debugger(), width, kLeastDebuggerHeight, {}).play(parse_script("wait 3"));
    const PanelArea tools = test::DefaultWindow(width, kLeastDebuggerHeight).all().tools;
    for (const std::string name : {"objects", "operators", "colour", "focus", "show all", "depth"}) {
      const std::string what = name + " in a window " + std::to_string(width) + " wide";
      expect_within(part(name), tools, what);
      EXPECT_EQ(part(name).height, part("objects").height) << what;
    }
  }
}

TEST_F(LeastSize, TheCountOfEventsIsBesideItsBox) {
  play(kGoToSplit);
  const PanelArea count = part("events shown");
  const PanelArea box = part("without objects");
  EXPECT_LE(count.x + count.width, box.x);
  expect_within(box, kWindow.area(PanelId::events), "box");
}

/// Every text ends within the window.
TEST_F(LeastSize, TheStatusLineIsNotClipped) {
  play(kGoToSplit);
  const PanelArea panel = kWindow.all().transport;
  for (const std::string& message :
       {std::string("compared with x.kerf"), std::string(300, 'm'), std::string(3000, 'm')}) {
    debugger().model().message = message;
    play("wait 1");
    expect_within(part("message"), panel, message);
  }
}

}  // namespace
}  // namespace kerf
