#include <gmock/gmock.h>

#include <fstream>

#include "tests/support/temporary_folder.h"
#include "tests/viz/debugger/timeline_driver.h"
#include "viz/debugger/session/session_text.h"

namespace kerf {
namespace {

using testing::HasSubstr;

/// Debuggers on one recording, one after another, that keep sessions beside it.
class DebuggerSessions : public testing::Test {
 protected:
  DebuggerSessions() { test::record_crowd<2>(recording(), 60, test::busy_config()); }

  [[nodiscard]] std::filesystem::path recording() const { return file_.path(); }
  [[nodiscard]] std::filesystem::path session() const { return recording().string() + ".session"; }
  /// What the script failed with; it is played as the window does, from its opening to its end.
  std::string play(const std::string& script) {
    Debugger debugger(*context_, open_run(recording()));
    debugger.model().work_folder = scratch_.path();
    debugger.keep_sessions_beside();
    const std::string problem = test::played(debugger, script);
    (void)debugger.keep_session();
    return problem;
  }

  std::unique_ptr<GlContext> context_ = make_offscreen_context();
  test::TemporaryRecording file_;
  test::TemporaryFolder scratch_;
};

constexpr const char* kWork = R"(
expect offer == none
click "go to"
type 20
key Enter
key B
click "note 0"
type "grown tree"
key Enter
click condition
type "op==merge"
key Enter
click n0
key +
drag view@0.3,0.3 view@0.4,0.4
)";

TEST_F(DebuggerSessions, GoOnWhereTheLastOneWas) {
  ASSERT_EQ(play(std::string(kWork) + "expect note0 == \"grown tree\""), "");
  ASSERT_TRUE(std::filesystem::exists(session()));
  EXPECT_EQ(play(R"(
expect offer == "1 breakpoint, 1 bookmark, step 20"
expect offer_warning == none
expect bookmarks == 0
key Enter
expect offer == none
expect step == 20
expect breakpoint0 == "op==merge"
expect note0 == "grown tree"
expect selection == n0
expect lanes_to == 40
expect message == "went on at 1 breakpoint, 1 bookmark, step 20"
key shift+.
)"),
            "");
  EXPECT_EQ(read_session_file(session()).position, Position::end_of(21));
}

TEST_F(DebuggerSessions, EscapeBeginsAnewAndKeepsTheEarlierOne) {
  ASSERT_EQ(play(kWork), "");
  EXPECT_EQ(play("key Escape\nexpect offer == none\nexpect breakpoints == 0\nkey B"), "");
  EXPECT_EQ(read_session_file(session()).breakpoints.size(), 0U);
  EXPECT_EQ(read_session_file(session().string() + ".earlier").breakpoints.size(), 1U);
}

TEST_F(DebuggerSessions, AnOfferWithoutAnAnswerLosesNothing) {
  ASSERT_EQ(play(kWork), "");
  const DebuggerSession kept = read_session_file(session());
  EXPECT_EQ(play("key End"), "");
  EXPECT_EQ(read_session_file(session()), kept);
  EXPECT_EQ(play("key End\nkey B"), "");
  EXPECT_EQ(read_session_file(session()).bookmarks.size(), 2U) << "what was made meanwhile, too";
  EXPECT_EQ(play("key Home\nkey B\nkey Enter\nexpect bookmarks == 3\nexpect breakpoints == 1"), "");
}

TEST_F(DebuggerSessions, LookingAroundAloneMakesNoFile) {
  EXPECT_EQ(play("key End\nkey +\ndrag view@0.3,0.3 view@0.4,0.4"), "");
  EXPECT_FALSE(std::filesystem::exists(session()));
}

TEST_F(DebuggerSessions, OneOfAnotherRecordingSaysSo) {
  ASSERT_EQ(play(kWork), "");
  std::filesystem::remove(recording());
  test::record_crowd<2>(recording(), 12, test::busy_config());
  EXPECT_EQ(play(R"(
expect offer_warning ~ "made for another recording"
key Enter
expect message ~ "this recording does not have: 1 bookmark, the moment"
expect breakpoints == 1
)"),
            "");
}

TEST_F(DebuggerSessions, ADamagedFileStaysAsItIs) {
  std::ofstream(session()) << "{\"format\": \"kerf-session\", \"version\": 7}";
  EXPECT_EQ(play("expect message ~ \"version is 7\"\nkey B"), "");
  EXPECT_THROW((void)read_session_file(session()), SessionError);
}

TEST_F(DebuggerSessions, NoneIsKeptOfAScratchRecording) {
  const auto scratch = scratch_.path() / "run.kerf";
  std::filesystem::copy_file(recording(), scratch);
  Debugger debugger(*context_, open_run(scratch));
  debugger.model().work_folder = scratch_.path();
  debugger.keep_sessions_beside();
  ASSERT_EQ(test::played(debugger, "key B"), "");
  EXPECT_EQ(debugger.keep_session(), "");
  EXPECT_FALSE(std::filesystem::exists(scratch.string() + ".session"));
}

TEST_F(DebuggerSessions, ScriptsKeepNoneUnlessTheySaySo) {
  Debugger debugger(*context_, open_run(recording()));
  EXPECT_EQ(test::played(debugger, kWork), "");
  EXPECT_EQ(debugger.keep_session(), "");
  EXPECT_FALSE(std::filesystem::exists(session()));
  EXPECT_EQ(test::played(debugger, "save session"), "");
  EXPECT_TRUE(std::filesystem::exists(session()));
  Debugger next(*context_, open_run(recording()));
  EXPECT_EQ(test::played(next, "expect bookmarks == 0\nload session\nexpect bookmarks == 1"), "");
  EXPECT_THAT(test::played(next, "load session /none"), HasSubstr("line 1, 'load session /none': "));
  EXPECT_THAT(test::played(next, "save session " + recording().string()), HasSubstr("stays as it is"));
  EXPECT_THAT(test::played(next, "save everything"), HasSubstr("save session [FILE]"));
}

TEST_F(DebuggerSessions, SeveralAreJoinedIntoTheOneBesideTheRecording) {
  const auto write = [&](const std::string& name, const Position& mark, const std::string& note) {
    Debugger debugger(*context_, open_run(recording()));
    debugger.model().bookmarks[mark] = note;
    EXPECT_EQ(debugger.save_session(scratch_.path() / name), "");
    return scratch_.path() / name;
  };
  const auto a = write("a", Position::end_of(3), "mine");
  const auto b = write("b", Position::end_of(3), "yours");
  const DebuggerSession of_a = read_session_file(a);
  std::filesystem::rename(write("c", Position::end_of(5), ""), session());
  Debugger debugger(*context_, open_run(recording()));
  debugger.model().work_folder = scratch_.path();
  debugger.go_on_with_files({a, b});
  EXPECT_EQ(debugger.model().bookmarks.size(), 2U);
  EXPECT_EQ(debugger.model().bookmarks.at(Position::end_of(3)), "mine / yours");
  EXPECT_EQ(debugger.keep_session(), "");
  EXPECT_EQ(read_session_file(session()).bookmarks, debugger.model().bookmarks);
  EXPECT_EQ(read_session_file(a), of_a) << "the given ones stay";
}

TEST_F(DebuggerSessions, AnotherRecordingIsOpenedWithItsOwn) {
  const auto other = scratch_.path() / "kept" / "other.kerf";
  std::filesystem::create_directory(other.parent_path());
  test::record_crowd<3>(other, 30, test::busy_config());
  EXPECT_EQ(play("key B\ndrop " + other.string() + R"(
expect recording == other.kerf
expect steps == 30
expect bookmarks == 0
expect message ~ "opened "
key B
key End
wait 2
)"),
            "");
  EXPECT_EQ(read_session_file(session()).bookmarks.size(), 1U);
  EXPECT_EQ(read_session_file(other.string() + ".session").recording.dimension, 3);
}

TEST_F(DebuggerSessions, TheWindowStaysAsItIsWhenAnotherRecordingIsOpened) {
  const auto other = scratch_.path() / "other.kerf";
  test::record_crowd<2>(other, 30, test::busy_config());
  EXPECT_EQ(play(R"(
key P
type "dark theme"
key Enter
key P
type "larger text"
key Enter
drag "divider left" 400,300
wait 1
remember window window
expect window ~ dark
drop )" + other.string() +
                 R"(
expect recording == other.kerf
expect theme == dark
expect zoom == 1.1
expect window == $window
)"),
            "");
}

TEST_F(DebuggerSessions, WhatIsNoRecordingLeavesTheRunAsItIs) {
  std::ofstream(scratch_.path() / "letter") << "dear";
  EXPECT_EQ(play("key B\nkey End\ndrop " + (scratch_.path() / "letter").string() + R"(
expect steps == 60
expect step == 60
expect bookmarks == 1
expect message ~ letter
drop /none/at/all
expect message ~ /none/at/all
expect step == 60
)"),
            "");
}

TEST_F(DebuggerSessions, TheSearchBoxCompletesPathsAndHasTheLatest) {
  const auto folder = scratch_.path() / "runs";
  std::filesystem::create_directory(folder);
  std::filesystem::copy_file(recording(), folder / "first.kerf");
  Debugger debugger(*context_, open_run(recording()));
  debugger.model().work_folder = folder / "none";
  debugger.remember_in(scratch_.path() / "config");
  EXPECT_EQ(test::played(debugger, "key ctrl+o\nexpect search == \"open: open \"\ntype " +
                                       scratch_.path().string() + R"(/ru
key Tab
expect search ~ runs/
type fi
key Enter
expect search == closed
expect recording == first.kerf
key P
type crowd
key Enter
expect recording == crowd.kerf
key P
type "recording open"
key Enter
expect search == "open: open "
type first
key Enter
expect recording == first.kerf
)"),
            "");
}

class ViewChanges : public testing::Test {
 protected:
  test::TimelineDriver driver;
};

TEST_F(ViewChanges, AreTakenBackAndMadeAgain) {
  EXPECT_EQ(driver.play(R"(
key End
click partitioners
remember without layers
drag view@0.3,0.3 view@0.5,0.5
click n0
key h
key +
expect lanes_from != 0
expect changes == 5
key ctrl+z
expect lanes_from == 0
expect hidden == 1
key ctrl+z
expect hidden == 0
expect selection == n0
key ctrl+z
expect selection == nothing
key ctrl+z
key ctrl+z
expect layers != $without
expect changes == 0
key ctrl+z
expect message == "no change of the view to take back"
key ctrl+y
expect layers == $without
key ctrl+shift+z
key ctrl+y
expect selection == n0
expect step == 60
)"),
            "");
}

TEST_F(ViewChanges, TheCameraGoesBackToTheSamePicture) {
  EXPECT_EQ(driver.play("key End\nhover 5,5\nwait 40"), "");
  const Image before = driver.debugger().picture();
  EXPECT_EQ(driver.play("drag view@0.3,0.3 view@0.5,0.5\nwheel 3\nhover 5,5\nwait 40"), "");
  EXPECT_NE(driver.debugger().picture(), before);
  EXPECT_EQ(driver.play("key ctrl+z\nkey P\ntype \"undo change\"\nkey Enter\nhover 5,5\nwait 40"), "");
  driver.debugger().report("", false);
  EXPECT_EQ(driver.play("wait 2"), "");
  EXPECT_EQ(driver.debugger().picture(), before);
}

TEST(Bookmarks, HaveNotesThatAreFoundAndShown) {
  test::TimelineDriver driver;
  EXPECT_EQ(driver.play(R"(
key End
key shift+B
expect bookmarks == 1
type "the tree is grown"
key Enter
expect note0 == "the tree is grown"
key Home
key b
expect bookmarks == 2
click "bookmark 1"
expect step == 60
key P
type "GROWN tree"
expect search == "open: GROWN tree"
key Enter
expect step == 60
key Home
click "remove bookmark 1"
expect bookmarks == 1
key shift+b
expect bookmarks == 1
)"),
            "");
}

TEST(Copying, EachPanelUnderTheMouseOrByName) {
  test::TimelineDriver driver;
  EXPECT_EQ(driver.play(R"(
key End
hover "panel events"
key ctrl+c
expect copied ~ "event"
expect message ~ "copied events, "
key ctrl+shift+c
expect copied ~ "event,step,what"
hover "panel transport"
key ctrl+c
expect copied ~ "end of step 60, of 60 steps, state "
hover "panel tree"
key ctrl+shift+c
expect copied ~ "node,depth,population,balance,cut"
expect copied ~ "n0,0,"
hover "panel breakpoints"
key ctrl+c
expect message == "breakpoints and bookmarks has nothing to copy"
key shift+b
type "a, b"
key Enter
hover "panel breakpoints"
key ctrl+shift+c
expect copied ~ "bookmark,step 60,,,,"
hover "panel timeline"
key ctrl+shift+c
expect copied ~ "step,operators"
click n0
hover "panel why"
key ctrl+c
expect message == "copied why"
click Oracle
expect message == "copied why"
key P
type "copy lanes as"
key Enter
expect message == "copied lanes, 60 rows as CSV"
click Tables
hover "divider left"
expect pointer == "across"
hover "panel tables"
key ctrl+shift+c
expect message ~ "copied table, "
expect copied ~ "node,depth"
hover view
key ctrl+shift+c
expect message ~ "copied scene, "
expect copied ~ "object,leaves,pairs,moves,x,y,"
click "What if"
hover "panel what if"
key ctrl+shift+c
expect copied ~ "parameter,value,least,greatest,meaning"
expect copied ~ "min_balance,"
)"),
            "");
}

TEST(TextTable, IsCsvAndText) {
  const TextTable table{{"a", "b"}, {{"1", "x,y"}, {"22", "say \"no\""}, {"", ""}}};
  EXPECT_EQ(to_csv(table), "a,b\n1,\"x,y\"\n22,\"say \"\"no\"\"\"\n,\n");
  EXPECT_EQ(to_text(table), "a   b\n1   x,y\n22  say \"no\"\n\n");
}

}  // namespace
}  // namespace kerf
