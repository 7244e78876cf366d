#include "viz/debugger/debugger.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>

#include "tests/images/reference_frames.h"
#include "tests/support/default_window.h"
#include "tests/support/recorded_crowd.h"
#include "tests/support/tampering.h"
#include "viz/debugger/script.h"
#include "viz/image/image.h"

namespace kerf {
namespace {

constexpr int kWidth = 1280;
constexpr int kHeight = 720;

GlBackend backend() {
  const char* chosen = std::getenv("KERF_BACKEND");
  return chosen == nullptr ? GlBackend::any : parse_gl_backend(chosen);
}

/// The part of the debugger's picture in an area that lies within it.
Image cut_out(const Image& image, const PanelArea& area) {
  Image part = make_image(static_cast<int>(area.width), static_cast<int>(area.height));
  for (int y = 0; y < part.height; ++y)
    std::copy_n(image.pixel(static_cast<int>(area.x), static_cast<int>(area.y) + y), part.stride(),
                part.rgba.begin() + static_cast<std::ptrdiff_t>(part.stride()) * y);
  return part;
}

/// A run that took no time: measured times differ from run to run.
template <int D>
void record_timeless(const test::TemporaryRecording& file, const Config& config) {
  test::record_crowd<D>(file.path(), 60, config);
  file.change(
      "UPDATE steps SET place_seconds = 0, sort_seconds = 0, schedule_seconds = 0, operate_seconds = 0, "
      "sweep_seconds = 0");
  test::reseal(file.path());
}

/// The debugger on a timeless run. Each panel is a reference of its own, so that a change of one needs one
/// approval.
template <int D>
class DebuggerStill {
 public:
  DebuggerStill() {
    record_timeless<D>(file_, test::busy_config());
    debugger_.emplace(*context_, open_run(file_.path()));
  }

  void play(const std::string& script) {
    ScriptPlayer(*debugger_, kWidth, kHeight, {}).play(parse_script(script));
  }

  [[nodiscard]] Debugger& debugger() { return *debugger_; }

  /// What has changed of a part of the debugger. Instead of texts its draw list has the names of what can be
  /// pressed.
  std::string compare(const std::string& name, const PanelArea& area) {
    const Image image = cut_out(debugger_->picture(), area);
    StoredIds stored{{{}, make_image(image.width, image.height, 0x000000ff)}, context_->rasterizer()};
    for (const auto& [part, place] : debugger_->gui().named()) {
      const auto x = static_cast<int>(place.x - area.x);
      const auto y = static_cast<int>(place.y - area.y);
      if (x >= 0 && y >= 0 && x < image.width && y < image.height)
        stored.ids.list.texts.push_back({x, y, part});
    }
    return test::compare_with_reference("debugger-" + name, image, stored);
  }

 private:
  test::TemporaryRecording file_;
  std::unique_ptr<GlContext> context_ = make_offscreen_context(backend());
  std::optional<Debugger> debugger_;
};

const test::DefaultWindow kWindow(kWidth, kHeight);

// At a split, whose ballot can be seen.
constexpr const char* kGoToSplit = R"(
click condition
type "op==split && kind==acted && step>20"
key Enter
key Escape
key F5
expect deed ~ split
)";

TEST(ReferencePanels, PanelsOfTheDebugger) {
  DebuggerStill<3> still;
  still.play(kGoToSplit);
  EXPECT_EQ(still.compare("transport", kWindow.all().transport), "");
  EXPECT_EQ(still.compare("tree", kWindow.area(PanelId::tree)), "");
  EXPECT_EQ(still.compare("icicle", kWindow.area(PanelId::icicle)), "");
  EXPECT_EQ(still.compare("breakpoints", kWindow.area(PanelId::breakpoints)), "");
  EXPECT_EQ(still.compare("events", kWindow.area(PanelId::events)), "");
  EXPECT_EQ(still.compare("view-3d", kWindow.all().view), "");
  EXPECT_EQ(still.compare("tools", kWindow.all().tools), "");
  EXPECT_EQ(still.compare("lanes", kWindow.area(PanelId::timeline)), "");
  still.play("drag scrubber@0.3,0.5 scrubber@0.4,0.5 shift\nkey R\nkey L\nhover 5,300\nwait 2");
  EXPECT_EQ(still.compare("lanes-range", kWindow.area(PanelId::timeline)), "");
  still.play("key +\nkey +\nkey +\nkey +\nkey B\nclick n0\nhover 5,300\nwait 2");
  EXPECT_EQ(still.compare("lanes-events", kWindow.area(PanelId::timeline)), "");
}

/// The bounds of nodes that it visited and pruned, what it found, and the reasons.
TEST(ReferencePanels, AQuery) {
  DebuggerStill<3> still;
  still.play(kGoToSplit);
  still.play("key P\ntype \"ray 4,3,-9,0,0.02,1\"\nkey Enter\nclick \"tab Why\"\nhover 5,300\nwait 2");
  EXPECT_EQ(still.compare("view-query-3d", kWindow.all().view), "");
  EXPECT_EQ(still.compare("tab-why-query", kWindow.area(PanelId::why)), "");
}

TEST(ReferencePanels, TabsOfTheDebugger) {
  DebuggerStill<2> still;
  still.play(kGoToSplit);
  const auto compare_tab = [&](const std::string& name) {
    return still.compare("tab-" + name, kWindow.area(PanelId::why));
  };
  EXPECT_EQ(compare_tab("why-event"), "");
  still.play("click \"tab Ballot\"\nhover \"candidate 1\"\nwait 2");
  EXPECT_EQ(compare_tab("ballot"), "");
  EXPECT_EQ(still.compare("view-2d", kWindow.all().view), "");  // with the candidate
  still.play("click \"tab Algorithm\"\nhover 5,300\nwait 2");
  EXPECT_EQ(compare_tab("algorithm"), "");
  still.play("click \"tab Oracle\"\nkey O\nhover 5,300\nwait 2");
  EXPECT_EQ(compare_tab("oracle"), "");
  still.play("click \"tab Lint\"\nhover 5,300\nwait 2");
  EXPECT_EQ(compare_tab("lint"), "");
  still.play("key End\nkey T\nclick \"sort cost\"\nclick \"row n1\"\nhover 5,300\nwait 2");
  EXPECT_EQ(compare_tab("tables-nodes"), "");
  EXPECT_EQ(still.compare("icicle-selected", kWindow.area(PanelId::icicle)), "");
  still.play("key Escape\nkey shift+T\nclick \"sort age\"\nhover 5,300\nwait 2");
  EXPECT_EQ(compare_tab("tables-pairs"), "");
  still.play("double object:40\nhover 5,300\nwait 2");
  EXPECT_EQ(still.compare("lanes-object",
                          test::DefaultWindow(kWidth, kHeight, kLanesOfRun + 3).area(PanelId::timeline)),
            "");
  still.play(std::string("key Escape\nkey Home\nkey F5\nkey A\nhover 5,300\nwait 2\nexpect deed ~ split"));
  EXPECT_EQ(still.compare("icicle-before", kWindow.area(PanelId::icicle)), "");
  still.play("key A\ndouble object:3\ndouble object:7 shift\nclick \"tab Why\"\nhover 5,300\nwait 2");
  EXPECT_EQ(compare_tab("why-pair"), "");
}

TEST(ReferencePanels, TabsOfComparing) {
  DebuggerStill<2> still;
  still.play(kGoToSplit);
  still.play("click \"tab What if\"\nhover 5,300\nwait 2");
  EXPECT_EQ(still.compare("tab-what-if", kWindow.area(PanelId::why)), "");
  const test::TemporaryRecording other;
  Config config = test::busy_config();
  config.balance = false;
  record_timeless<2>(other, config);
  still.play("click \"tab Compare\"\nclick \"other file\"\ntype \"" + other.path().string() +
             "\"\nkey Enter\nkey Escape\nwait 2\nclick \"first different operator\"\nhover 5,300\nwait 2\n"
             "expect comparing == yes");
  EXPECT_EQ(still.compare("tab-compare", kWindow.area(PanelId::why)), "");
  EXPECT_EQ(still.compare("view-compared", kWindow.all().view), "");
  EXPECT_EQ(still.compare("lanes-compared", kWindow.area(PanelId::timeline)), "");
}

}  // namespace
}  // namespace kerf
