#include "viz/debugger/session/session.h"

#include <gmock/gmock.h>

#include <fstream>

#include "tests/support/temporary_folder.h"
#include "tests/viz/debugger/timeline_driver.h"
#include "viz/debugger/session/recent_files.h"
#include "viz/debugger/session/session_keeper.h"
#include "viz/debugger/session/session_text.h"

namespace kerf {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

DebuggerSession full_session() {
  DebuggerSession session;
  session.recording = {"pile", 3, 300, "0123456789abcdef"};
  session.breakpoints = {{"op==merge && depth>8", true}, {"pair(12,77) enters", false}};
  session.watches = {{"redundancy", std::nullopt}, {"depth", Change::any}, {"pairs>3", Change::becomes_true}};
  session.bookmarks = {{Position::end_of(4), ""}, {{7, 278}, "a \"note\",\nüber two lines"}};
  session.view.layers = LayerSet::parse("objects,legend", LayerSet::none());
  session.view.tint = Tint::age;
  session.view.query = "ray 0,2,1,0";
  session.view.least_depth = 2;
  session.view.greatest_depth = 9;
  session.view.isolated = NodeId{4};
  session.view.hidden_nodes = {{5}, {6}};
  session.view.hidden_objects = {{7}};
  session.camera = CameraChoice<3>{.yaw = 12.5,
                                   .pitch = 1 / 3.0,
                                   .fov = 40,
                                   .distance = 7,
                                   .target = Eigen::Vector3d(1, 2, 3),
                                   .framing = {}};
  session.selection = Pair{{3}, {9}};
  session.position = {7, 278};
  session.lanes = {2.25, 17.75, "pairs", false, StepSpan{3, 8}, true, EventKind::shift_split};
  return session;
}

TEST(Session, TextGivesItBack) {
  DebuggerSession session = full_session();
  EXPECT_EQ(read_session(write_session(session)), session);
  session.camera =
      CameraChoice<2>{.center = Eigen::Vector2d(0.1, -5), .width = 3, .framing = Framing::everything};
  for (const Selection& selection : {Selection(), Selection(NodeId{8}), Selection(ObjectId{8})}) {
    session.selection = selection;
    session.view.isolated.reset();
    session.lanes.range.reset();
    EXPECT_EQ(read_session(write_session(session)), session);
  }
  EXPECT_EQ(read_session(write_session({})), DebuggerSession());
}

std::string problem_of(const std::string& text) {
  try {
    (void)read_session(text);
  } catch (const SessionError& error) {
    return error.what();
  }
  return "";
}

/// The full session with one text in place of another.
std::string changed(const std::string& from, const std::string& to) {
  std::string text = write_session(full_session());
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(Session, SaysWhyATextCannotBeRead) {
  EXPECT_THAT(problem_of(changed(R"("version": 1)", R"("version": 2)")), HasSubstr("version is 2"));
  for (const char* const other : {"{}", "[]", "3", R"({"format": "kerf-cell-1"})"})
    EXPECT_THAT(problem_of(other), HasSubstr("no session of kerf debug")) << other;
  for (const char* const damaged : {"", "{", "\x01", R"({"format": "kerf-session"})"})
    EXPECT_THAT(problem_of(damaged), HasSubstr("damaged")) << damaged;
}

/// The messages of the JSON library name its parts, not those of a session.
TEST(Session, WhatIsDamagedIsSaidInPlainWords) {
  EXPECT_THAT(problem_of(changed(R"("note": "")", R"("not": "")")), HasSubstr("key 'note' not found"));
  const std::string list = R"({"format": "kerf-session", "version": 1, "recording": []})";
  EXPECT_THAT(problem_of(list), HasSubstr("of another kind than in a session"));
  EXPECT_THAT(problem_of("{"), HasSubstr("it is no JSON from byte 2 on"));
  for (const std::string& text : {std::string("{"), list, changed(R"("note": "")", R"("not": "")")})
    EXPECT_THAT(problem_of(text), testing::Not(HasSubstr("json.exception"))) << text;
}

TEST(Session, DamagedPartsAreRefused) {
  const std::vector<std::pair<std::string, std::string>> changes{
      {R"("step": 4)", R"("step": -4)"},
      {R"("step": 4)", R"("step": 4294967296)"},
      {R"("step": 4)", R"("step": 4.5)"},
      {R"("enabled": true)", R"("enabled": 3)"},
      {"op==merge", "op==nothing"},
      {R"("stops_when": "true")", R"("stops_when": "later")"},
      {R"("colour": "age")", R"("colour": "taste")"},
      {R"("layers": "objects)", R"("layers": "subjects)"},
      {R"("query": "ray)", R"("query": "beam)"},
      {R"("distance": 7.0)", R"("distance": 0)"},
      {R"("from": 2.25)", R"("from": 1e999)"},
      {R"("kind": "shift-split")", R"("kind": "party")"},
      {R"("bookmarks")", R"("bookmark")"}};
  for (const auto& [from, to] : changes)
    EXPECT_THAT(problem_of(changed(from, to)), HasSubstr("damaged")) << to;
}

TEST(Session, JoinsWhatTwoPeopleDid) {
  DebuggerSession a = full_session();
  DebuggerSession b = full_session();
  a.breakpoints = {{"depth>1", true}, {"depth>2", false}};
  b.breakpoints = {{"depth>2", true}, {"depth>3", false}};
  a.watches = {{"pairs", std::nullopt}};
  b.watches = {{"depth", Change::any}, {"pairs", Change::any}};
  a.bookmarks = {{Position::end_of(1), "mine"}, {Position::end_of(2), ""}, {Position::end_of(3), "same"}};
  b.bookmarks = {{Position::end_of(1), "yours"}, {Position::end_of(3), "same"}, {{4, 9}, "new"}};
  b.view.tint = Tint::cost;
  const DebuggerSession joined = join(a, b);
  EXPECT_EQ(joined.breakpoints,
            (std::vector<DebuggerSession::Stop>{{"depth>1", true}, {"depth>2", true}, {"depth>3", false}}));
  EXPECT_EQ(joined.watches,
            (std::vector<DebuggerSession::Watch>{{"pairs", Change::any}, {"depth", Change::any}}));
  EXPECT_EQ(joined.bookmarks, (std::map<Position, std::string>{{Position::end_of(1), "mine / yours"},
                                                               {Position::end_of(2), ""},
                                                               {Position::end_of(3), "same"},
                                                               {{4, 9}, "new"}}));
  EXPECT_EQ(joined.view, a.view) << "all else is the first one's";
  EXPECT_EQ(join(joined, b), joined) << "joined twice";
  EXPECT_EQ(join(a, a), a);
}

TEST(Session, HoldsWhatAnotherOneHas) {
  const DebuggerSession a = full_session();
  EXPECT_TRUE(holds(a, a));
  EXPECT_TRUE(holds(a, {}));
  EXPECT_FALSE(holds({}, a));
  const auto without = [&](auto change) {
    DebuggerSession less = a;
    change(less);
    return holds(less, a);
  };
  EXPECT_FALSE(without([](DebuggerSession& less) { less.breakpoints.pop_back(); }));
  EXPECT_FALSE(without([](DebuggerSession& less) { less.watches.pop_back(); }));
  EXPECT_FALSE(without([](DebuggerSession& less) { less.bookmarks.erase(less.bookmarks.begin()); }));
  EXPECT_FALSE(without([](DebuggerSession& less) { less.bookmarks.rbegin()->second = "other"; }));
  EXPECT_FALSE(without([](DebuggerSession& less) { less.view = {}; }));
  EXPECT_FALSE(without([](DebuggerSession& less) { less.lanes.range.reset(); }));
  EXPECT_TRUE(without([](DebuggerSession& less) { less.position = Position::end_of(1); }));
}

/// The debugger on a run, with something of each kind made in it.
class SessionOfRun : public testing::Test {
 protected:
  void make_something() {
    model().go(Position::end_of(20));
    model().add_breakpoint("op==merge && kind==acted");
    model().add_watch("pairs");
    model().stop_at_watch(0, Change::any);
    model().toggle_bookmark();
    model().bookmarks.begin()->second = "grown";
    model().view.tint = Tint::cost;
    model().select(NodeId{0});
    model().timeline.window.show(10, 30);
    model().timeline.range = StepSpan{12, 14};
    model().timeline.lane = 1;
  }
  DebuggerModel& model() { return driver.debugger().model(); }
  DebuggerSession session() { return session_of(model(), driver.debugger().view().camera()); }

  test::TimelineDriver driver;
};

TEST_F(SessionOfRun, ANewDebuggerGoesOnThere) {
  EXPECT_FALSE(has_anything(session()));
  make_something();
  EXPECT_TRUE(has_anything(session()));
  EXPECT_EQ(to_text(session(), model().run().names()), "1 breakpoint, 1 watch, 1 bookmark, step 20");
  test::TimelineDriver other;
  EXPECT_EQ(go_on(session(), other.debugger().model()), "");
  EXPECT_EQ(session_of(other.debugger().model(), driver.debugger().view().camera()), session());
  EXPECT_TRUE(is_of(session().recording, other.debugger().model().run())) << "another recording of the same";
}

TEST_F(SessionOfRun, ALongerRunGoesOnFromTheSameSteps) {
  test::TimelineDriver longer(70);
  const RecordingMark mark = session().recording;
  EXPECT_TRUE(is_of(mark, longer.debugger().model().run()));
  EXPECT_FALSE(is_of(mark_of(longer.debugger().model().run()), model().run())) << "not the reverse";
  test::TimelineDriver other(test::LongRun{60});
  EXPECT_FALSE(is_of(mark, other.debugger().model().run()));
}

/// After objects were removed, ids are greater than the number of those that are there.
TEST_F(SessionOfRun, ASelectedObjectIsKeptWhereIdsHaveGaps) {
  model().go(Position::end_of(60));
  auto& run = model().run();
  ObjectId last{run.objects()};
  while (last.value < 1000 && !run.has(last)) ++last.value;
  ASSERT_TRUE(run.has(last));
  for (const Selection& selection : {Selection(last), Selection(Pair{{0}, last})}) {
    model().select(selection);
    const DebuggerSession kept = session();
    model().select({});
    EXPECT_EQ(go_on(kept, model()), "");
    EXPECT_EQ(model().selection(), selection);
  }
}

TEST_F(SessionOfRun, WhatTheRunDoesNotHaveIsLeftOut) {
  DebuggerSession far = full_session();
  far.bookmarks = {{Position::end_of(5), "here"}, {Position::end_of(61), ""}, {{3, 99'999'999}, ""}};
  far.position = Position::end_of(9000);
  far.selection = ObjectId{1'000'000};
  far.lanes.range = StepSpan{3, 8000};
  far.view.isolated = NodeId{4'000'000'000};
  EXPECT_EQ(go_on(far, model()), "2 bookmarks, the moment, the selection");
  EXPECT_THAT(model().bookmarks, testing::ElementsAre(testing::Pair(Position::end_of(5), "here")));
  EXPECT_EQ(model().timeline.range, std::nullopt);
  EXPECT_EQ(model().selection(), Selection());
  EXPECT_EQ(driver.play("wait 2\nkey End\nwait 2"), "");
}

class KeptSession : public testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file() const { return folder_.path() / "run.kerf.session"; }
  [[nodiscard]] static std::string content(const std::filesystem::path& path) {
    std::ifstream stream(path);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  test::TemporaryFolder folder_;
};

TEST_F(KeptSession, IsReadBackAndReplaced) {
  SessionKeeper keeper(file());
  EXPECT_EQ(keeper.read(), std::nullopt);
  EXPECT_EQ(keeper.keep(full_session()), "");
  DebuggerSession later = full_session();
  later.bookmarks.clear();
  EXPECT_EQ(keeper.keep(later), "");
  SessionKeeper next(file());
  EXPECT_EQ(next.read(), later);
  EXPECT_EQ(next.keep(full_session()), "");
  EXPECT_EQ(read_session_file(file()), full_session());
  EXPECT_FALSE(std::filesystem::exists(file().string() + ".earlier"));
}

TEST_F(KeptSession, AnEarlierOneThatIsNotGoneOnWithGetsAnotherName) {
  SessionKeeper(file()).keep(full_session());
  SessionKeeper keeper(file());
  (void)keeper.read();
  keeper.begin_anew();
  EXPECT_EQ(keeper.keep({}), "");
  EXPECT_EQ(read_session_file(file()), DebuggerSession());
  EXPECT_EQ(read_session_file(file().string() + ".earlier"), full_session());
}

TEST_F(KeptSession, AnEarlierOneIsReplacedOnlyByWhatHasAllOfIt) {
  const auto set_aside = [&](const DebuggerSession& session) {
    std::ofstream(file()) << write_session(session);
    SessionKeeper keeper(file());
    (void)keeper.read();
    keeper.begin_anew();
    EXPECT_EQ(keeper.keep({}), "");
    return keeper.take_note();
  };
  DebuggerSession more = full_session();
  more.bookmarks[Position::end_of(5)] = "more";
  DebuggerSession other = full_session();
  other.bookmarks.begin()->second = "another note";
  const std::string name = "the earlier session is kept as " + file().string() + ".earlier";
  EXPECT_EQ(set_aside(full_session()), name);
  EXPECT_EQ(set_aside(more), name);
  EXPECT_EQ(set_aside(other), name + "-2");
  EXPECT_EQ(read_session_file(file().string() + ".earlier"), more);
  EXPECT_EQ(read_session_file(file().string() + ".earlier-2"), other);
  std::ofstream(file().string() + ".earlier") << "a letter";
  EXPECT_EQ(set_aside(more), name + "-3");
  EXPECT_EQ(content(file().string() + ".earlier"), "a letter");
}

TEST_F(KeptSession, AnEarlierOneBehindALinkIsKept) {
  const auto behind = folder_.path() / "behind";
  SessionKeeper(behind).keep(full_session());
  std::filesystem::create_symlink(behind, file());
  SessionKeeper keeper(file());
  (void)keeper.read();
  keeper.begin_anew();
  EXPECT_EQ(keeper.keep({}), "");
  EXPECT_TRUE(std::filesystem::is_symlink(file()));
  EXPECT_EQ(read_session_file(file()), DebuggerSession());
  EXPECT_EQ(read_session_file(behind.string() + ".earlier"), full_session());
}

TEST_F(KeptSession, WhatIsNoSessionStaysAsItIs) {
  std::ofstream(file()) << "a letter";
  SessionKeeper keeper(file());
  EXPECT_THROW((void)keeper.read(), SessionError);
  EXPECT_EQ(keeper.keep(full_session()), "") << "said once";
  EXPECT_EQ(content(file()), "a letter");
  SessionKeeper unread(file());
  EXPECT_THAT(unread.keep(full_session()), HasSubstr("stays as it is"));
  EXPECT_EQ(content(file()), "a letter");
}

TEST_F(KeptSession, AFolderThatCannotBeWrittenIsSaidOnce) {
  SessionKeeper keeper(folder_.path() / "none" / "run.session");
  EXPECT_THAT(keeper.keep(full_session()), HasSubstr("is not saved"));
  EXPECT_EQ(keeper.keep({}), "");
  std::filesystem::create_directory(folder_.path() / "none");
  EXPECT_EQ(keeper.keep(full_session()), "");
  EXPECT_EQ(read_session_file(keeper.file()), full_session()) << "once it can be";
}

TEST_F(KeptSession, NothingIsKeptWithoutAFile) {
  EXPECT_EQ(SessionKeeper().keep(full_session()), "");
  EXPECT_TRUE(folder_.is_empty());
}

TEST(RecentFiles, AreTheLastTenWithoutDoubles) {
  const test::TemporaryFolder folder;
  const auto config = folder.path() / "config" / "kerf";
  RecentFiles recent(config);
  EXPECT_THAT(recent.files(), IsEmpty());
  for (int k = 0; k < 12; ++k) recent.add("/runs/" + std::to_string(k) + ".kerf");
  recent.add("/runs/other/../7.kerf");
  const RecentFiles read(config);
  EXPECT_EQ(read.files(), recent.files());
  ASSERT_EQ(read.files().size(), kMostRecent);
  EXPECT_EQ(read.files()[0], "/runs/7.kerf");
  EXPECT_EQ(read.files()[1], "/runs/11.kerf");
  EXPECT_EQ(read.files().back(), "/runs/2.kerf");
}

TEST(RecentFiles, WithoutAFolderTheyAreForgotten) {
  RecentFiles recent;
  recent.add("/runs/a.kerf");
  EXPECT_THAT(recent.files(), testing::ElementsAre("/runs/a.kerf"));
  RecentFiles unwritable("/dev/null/kerf");
  unwritable.add("/runs/a.kerf");
  unwritable.add("/runs/b.kerf");
  EXPECT_EQ(unwritable.files().size(), 2U);
}

TEST(RecentFiles, PathsAreCompleted) {
  const test::TemporaryFolder folder;
  const std::string in = folder.path().string() + "/";
  std::filesystem::create_directory(in + "runs");
  for (const char* const name : {"notes", "run.kerf", ".hidden", "row.kerf"}) std::ofstream(in + name) << "";
  EXPECT_THAT(complete_path(in + "r"), testing::ElementsAre(in + "runs/", in + "row.kerf", in + "run.kerf"));
  EXPECT_THAT(complete_path(in),
              testing::ElementsAre(in + "runs/", in + "row.kerf", in + "run.kerf", in + "notes"));
  EXPECT_THAT(complete_path(in + "."), testing::ElementsAre(in + ".hidden"));
  EXPECT_THAT(complete_path(in + "none/x"), IsEmpty());
}

}  // namespace
}  // namespace kerf
