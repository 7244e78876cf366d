#include "viz/debugger/script.h"

#include <gmock/gmock.h>

#include "tests/support/temporary_folder.h"
#include "tests/viz/debugger/timeline_driver.h"
#include "viz/image/png.h"

namespace kerf {
namespace {

using ::testing::HasSubstr;

TEST(Script, LinesHaveWordsQuotesAndComments) {
  const auto lines = parse_script("# nothing\n\nclick \"step forward\" # the button\n  expect step == 1");
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].number, 3);
  EXPECT_THAT(lines[0].words, testing::ElementsAre("click", "step forward"));
  EXPECT_THAT(lines[1].words, testing::ElementsAre("expect", "step", "==", "1"));
  EXPECT_THROW((void)parse_script("click \"open"), ScriptError);
}

/// A debugger without a window on a small crowd, driven by scripts.
class ScriptedDebugger : public testing::Test {
 protected:
  ScriptedDebugger() { test::record_crowd<3>(file_.path(), 60, test::busy_config()); }

  /// What the script failed with; empty if it did not.
  std::string play(const std::string& script, const std::string& folder = "pictures") {
    const auto context = make_offscreen_context();
    Debugger debugger(*context, open_run(file_.path()));
    debugger.model().work_folder = folder_.path();
    return test::played(debugger, script, 1280, 720, {.path = folder_.path() / folder});
  }
  [[nodiscard]] Image picture(const std::string& name, const std::string& folder = "pictures") const {
    return read_png(folder_.path() / folder / (name + ".png"));
  }

 private:
  test::TemporaryRecording file_;
  test::TemporaryFolder folder_;
};

TEST_F(ScriptedDebugger, MistakesAreNamedByTheirLine) {
  for (const char* const line : {"key Pgup", "click node:nan", "click node:-1", "click node:1e99",
                                 "click object:4294967296", "click object:1.5", "click nan,5", "click 5,inf",
                                 "click 1e30,5", "click view@nan,0", "click view@0,1e30", "wait 1e99",
                                 "wait nan", "wait -1", "wait 2.5", "wheel nan", "wheel 1e99", "wheel up"})
    EXPECT_THAT(play("key Home\n" + std::string(line)), HasSubstr("line 2, '" + std::string(line) + "': "));
}

TEST_F(ScriptedDebugger, PlacesOutsideTheWindowAndEmptyNamesAreRefused) {
  for (const char* const line : {"click 99999,99999", "click -5,-5", "hover -5,-5", "drag view 5,99999"})
    EXPECT_THAT(play(line), HasSubstr("is no pixel of the window, which has ")) << line;
  for (const char* const line : {"click scrubber@7,7", "hover view@0.5,-0.1", "drag view@0.5,1.01 view"})
    EXPECT_THAT(play(line), HasSubstr("two shares from 0 to 1")) << line;
  for (const char* const line : {"drop \"\"", "save session \"\"", "load session \"\""})
    EXPECT_THAT(play(line), HasSubstr("it is written `")) << line;
}

TEST_F(ScriptedDebugger, KeysButtonsAndScrubberGoThroughTheRun) {
  EXPECT_EQ(play(R"(
expect position == "step 0"
key shift+.
expect step == 1
click "step forward"
expect step == 2
key End
expect step == 60
key shift+,
expect step == 59
click start
expect step == 0
drag scrubber@0,0.5 scrubber@0.5,0.5
expect step == 30
click "go to"
type 17
key Enter
expect position == "step 17"
expect message == ""
key .
expect event != none
remember first event
key .
expect event != $first
key ,
expect event == $first
key Space
expect playing == yes
key Space
expect playing == no
)"),
            "");
}

TEST_F(ScriptedDebugger, BackIsTheSameStateAndTheSamePicture) {
  EXPECT_EQ(play(R"(
click "go to"
type 20
key Enter
hover 700,400
key .
key .
remember here state
key .
key .
key .
key ,
key ,
key ,   # the oracle was asked on the way, and the lanes show it
screenshot before
key .
key .
key .
expect state != $here
key ,
key ,
key ,
expect state == $here
screenshot after
)"),
            "");
  EXPECT_EQ(picture("before"), picture("after"));
}

TEST_F(ScriptedDebugger, TheSameScriptGivesTheSamePictures) {
  const std::string script =
      "key End\ndouble view@0.5,0.6\ndrag view@0.3,0.3 view@0.4,0.35\nwheel 2\nscreenshot a";
  ASSERT_EQ(play(script, "one"), "");
  ASSERT_EQ(play(script, "two"), "");
  EXPECT_EQ(picture("a", "one"), picture("a", "two"));
}

TEST_F(ScriptedDebugger, TypedConditionsStopTheRun) {
  EXPECT_EQ(play(R"(
click condition
type "op==swap && kind==acted"
key Enter
expect breakpoints == 1
expect breakpoint0 == "op==swap && kind==acted"
key Escape
key F5
expect deed ~ swap
expect hits0 == 1
remember first position
key F5
expect position != $first
key shift+F5
expect position == $first
click "breakpoint 0"
key F5
expect position == $first
expect message ~ "no breakpoint"
click condition
type "redundncy>1"
key Enter
expect problem ~ redundncy
click watch
type "100*2/8"
key Enter
expect watch0 == 25
click "remove watch 0"
click watch
type height
key Enter
key Escape
key Home
click "watch stop 0"
key F5
expect watch_hits0 == 1
expect message ~ "height has changed"
)"),
            "");
}

TEST_F(ScriptedDebugger, DoubleClickSelectsAndShiftMakesAPair) {
  EXPECT_EQ(play(R"(
key End
double object:3
expect selection ~ object
remember one selection
double object:7 shift
expect selection ~ pair
wait 2
expect explanation ~ "pair:"
key Escape
expect selection == nothing
remember all drawn_objects
double object:3
key H
wait 2
expect hidden == 1
expect drawn_objects < $all
remember others drawn_objects
key H
wait 2
expect drawn_objects == $all
expect drawn_objects > $others
click n0
expect selection == n0
key H
wait 2
expect hidden == 1
expect drawn_objects == 0
key H
wait 2
expect drawn_objects == $all
)"),
            "");
}

TEST_F(ScriptedDebugger, PartitionersAndLeavesArePickedInTheView) {
  EXPECT_EQ(play(R"(
key End
double node:0 ctrl
expect selection == n0
double node:1 ctrl
expect selection == n1
wait 2
expect explanation ~ "n1 (life"
click leaves
click objects
double node:2
expect selection == n2
click objects
double object:3
expect selection ~ object
hover 5,5
wait 30   # else it is a third click
double object:3 ctrl
expect selection ~ n
expect selection !~ object
double view@0.01,0.01
expect selection == nothing
)"),
            "");
}

TEST_F(ScriptedDebugger, ObjectsThatAreNoLayerAreNotCountedAsDrawn) {
  EXPECT_EQ(play(R"(
key End
wait 1
remember all all_objects
expect drawn_objects == $all
click objects
wait 1
expect drawn_objects == 0
expect all_objects == $all
click objects
wait 1
expect drawn_objects == $all
)"),
            "");
}

TEST_F(ScriptedDebugger, PanelsOpenAndCompare) {
  EXPECT_EQ(play(R"(
click condition
type "op==split && kind==acted"
key Enter
key Escape
key F5
click "tab Ballot"
wait 2
expect candidates > 1
hover "candidate 1"
expect candidate == 1
wait 1
remember plane candidate_plane
expect labels ~ $plane
hover "candidate 0"
wait 1
expect labels !~ $plane
hover "candidate 1"
wait 1
screenshot ballot
click "tab Algorithm"
click "tab Oracle"
click "tab Lint"
click "tab What if"
wait 2
click refuse
wait 2
expect comparing == yes
click "change over"
wait 2
expect comparing == yes
click "stop comparing"
expect comparing == no
key F1
expect help == yes
key Escape
expect help == no
)"),
            "");
}

/// A part of a panel is found by what is written on it, too.
TEST_F(ScriptedDebugger, PartsHaveTheNamesThatTheyShow) {
  EXPECT_EQ(play(R"(
click ">>"
expect step == 1
click "<<"
expect step == 0
click "|<"
click mark
expect bookmarks == 1
)"),
            "");
  const std::string go_to_split =
      "click condition\ntype \"op==split && kind==acted\"\nkey Enter\nkey Escape\nclick \"run >\"\n";
  const std::string found = play(go_to_split + "expect event == none");
  const std::string split = found.substr(found.rfind(" '") + 2, found.size() - found.rfind(" '") - 3);
  EXPECT_EQ(play(go_to_split + "click \"What if\"\nwait 2\nclick \"refuse " + split +
                 "\"\nwait 2\nexpect comparing == yes\nclick \"show both\"\nclick Why\n"),
            "");
  EXPECT_THAT(play("click \"tab Wy\""), HasSubstr("'tab Why'"));
}

TEST_F(ScriptedDebugger, AKeySeesTheSceneFromItsSides) {
  EXPECT_EQ(
      play("key End\nwait 1\nscreenshot usual\nkey v\nwait 1\nscreenshot iso\nkey v\nwait 1\nscreenshot top\n"
           "drag 600,300 650,330\nwait 1\nkey shift+v\nwait 1\nscreenshot again\n"),
      "");
  EXPECT_NE(picture("usual"), picture("iso"));
  EXPECT_NE(picture("iso"), picture("top"));
}

TEST_F(ScriptedDebugger, AClickMovesNothingThoughTheHandTrembles) {
  EXPECT_EQ(play("key End\nhover view@0.03,0.9\nwait 1\nscreenshot before\n"
                 "drag view@0.03,0.9 view@0.032,0.902\nhover view@0.03,0.9\nwait 1\nscreenshot after\n"
                 "drag view@0.03,0.9 view@0.04,0.92\nhover view@0.03,0.9\nwait 1\nscreenshot turned\n"),
            "");
  EXPECT_EQ(picture("before"), picture("after"));
  EXPECT_NE(picture("before"), picture("turned"));
}

TEST_F(ScriptedDebugger, ColoursEndAtTheSameValueInEveryMoment) {
  for (const char* const tint : {"population", "cost"})
    EXPECT_EQ(play("click colour\nclick \"colour " + std::string(tint) +
                   "\"\nwait 1\nremember end tint_end\nkey End\nwait 1\nexpect tint_end == $end\n"),
              "")
        << tint;
}

TEST_F(ScriptedDebugger, TheOtherRunFollowsAndHasTheSameColours) {
  EXPECT_EQ(play(R"(
click colour
click "colour cost"
click "tab What if"
wait 2
click assignments
type "min_threshold=20,max_threshold=40"
key Enter
wait 2
expect comparing == yes
key End
wait 1
remember shared tint_end
expect other_tint_end == $shared
click "change over"
wait 2
key End
wait 1
expect tint_end == $shared
expect other_tint_end == $shared
click "change over"
wait 2
click "first different operator"
wait 1
expect deed != none
expect other != "step 60"
expect other_deed != none
click "stop comparing"
key End
wait 1
expect tint_end <= $shared
)"),
            "");
}

TEST_F(ScriptedDebugger, AFailedExpectationNamesItsLineAndWhatWasFound) {
  EXPECT_THAT(play("key End\nexpect step == 3"), HasSubstr("line 2, 'expect step == 3': step is '60'"));
  EXPECT_THAT(play("press End"), HasSubstr("'press' is none of key, click"));
  EXPECT_THAT(play("click nowhere"), HasSubstr("there is no 'nowhere' to be seen"));
  EXPECT_THAT(play("expect speed == 3"), HasSubstr("there is nothing called 'speed'"));
  EXPECT_THAT(play("key F13"), HasSubstr("there is no key 'F13'"));
}

}  // namespace
}  // namespace kerf
